using System;
using System.Globalization;

namespace Rabit.Geodesy;

/// <summary>
/// A square of the Military Grid Reference System, from 100 km to 1 m wide, 80 degrees south to 84 north: as
/// 32TMT6500050000. A plain value.
/// </summary>
/// <remarks>
/// Rules: NGA.STND.0037, "Universal Grids and Grid Reference Systems", 2014. The squares about the poles (UPS, letters
/// A, B, Y, Z) are not known to it: they are refused, by an exception or by what is read being false.
/// </remarks>
public readonly record struct MgrsPosition
{
    private const string Columns = "ABCDEFGHJKLMNPQRSTUVWXYZ";
    private const string Rows = "ABCDEFGHJKLMNPQRSTUV";
    private const int Square = 100_000;
    private const int RowCycle = 2_000_000;

    // The least northing of each band, in 100 km, below its southern edge anywhere in a zone.
    private static readonly int[] MinNorthing =
        [11, 20, 28, 37, 46, 55, 64, 73, 82, 91, 0, 8, 17, 26, 35, 44, 53, 62, 70, 79];

    private readonly int _band;
    private readonly int _eastingMetres;
    private readonly int _northingMetres;

    private MgrsPosition(int zone, int band, int eastingMetres, int northingMetres, int digits)
    {
        Zone = zone;
        _band = band;
        _eastingMetres = eastingMetres;
        _northingMetres = northingMetres;
        Digits = digits;
    }

    /// <summary>1 to 60.</summary>
    public int Zone { get; }

    /// <summary>Letter of the band of latitude, C to X without I and O.</summary>
    public char Band => UtmZones.Bands[_band];

    /// <summary>How many digits each coordinate has: 5 for a square of 1 m, 0 for 100 km.</summary>
    public int Digits { get; }

    /// <summary>Width of the square, metres.</summary>
    public int WidthMetres => PowerOfTen(5 - Digits);

    /// <summary>The south-western corner of the square.</summary>
    public UtmPosition Corner => new(Zone, _band >= 10, _eastingMetres, _northingMetres);

    /// <summary>The middle of the square.</summary>
    public GeographicPoint Centre
        => new UtmPosition(
            Zone, _band >= 10, _eastingMetres + (WidthMetres / 2.0), _northingMetres + (WidthMetres / 2.0))
            .ToGeographic();

    /// <summary>The square that holds a place: coordinates are cut off, not rounded, as the rules demand.</summary>
    /// <param name="point">80 degrees south to 84 north.</param>
    /// <param name="digits">0 to 5: how many digits each coordinate has.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// The place is nearer to a pole, or the number of digits is another.
    /// </exception>
    public static MgrsPosition From(GeographicPoint point, int digits = 5)
    {
        if (digits is < 0 or > 5)
            throw new ArgumentOutOfRangeException(nameof(digits), digits, "A coordinate of MGRS has 0 to 5 digits.");
        if (point.Latitude.Degrees is < -80 or > 84)
        {
            throw new ArgumentOutOfRangeException(
                nameof(point), $"MGRS is known here from 80 degrees south to 84 north; at {point.Latitude} its squares "
                    + "are those of the polar grid (UPS).");
        }

        UtmPosition utm = UtmPosition.From(point);
        int width = PowerOfTen(5 - digits);
        int easting = (int)Math.Floor(utm.EastingMetres / width) * width;

        // At the equator from the south 10 000 000 m are reached by rounding.
        int northing = (int)Math.Floor(Math.Min(utm.NorthingMetres, 9_999_999.9) / width) * width;
        return new MgrsPosition(utm.Zone, UtmZones.BandOf(point.Latitude.Degrees), easting, northing, digits);
    }

    /// <summary>Reads one; small letters and spaces between the parts are allowed.</summary>
    /// <param name="text">As 32TMT6500050000 or 32T MT 65000 50000.</param>
    /// <param name="position">What it says; nothing if the answer is false.</param>
    public static bool TryParse(string? text, out MgrsPosition position)
    {
        position = default;
        string compact = (text ?? "").Replace(" ", "").ToUpperInvariant();
        int letters = 0;
        while (letters < compact.Length && compact[letters] is >= '0' and <= '9')
            letters++;
        if (letters is < 1 or > 2 || compact.Length < letters + 3
            || (compact.Length - letters - 3) is var count && (count % 2 != 0 || count > 10))
            return false;
        int zone = compact[0] - '0';
        if (letters == 2)
            zone = (10 * zone) + (compact[1] - '0');
        int band = UtmZones.Bands.IndexOf(compact[letters]);
        int column = Columns.IndexOf(compact[letters + 1]) - (((zone + 2) % 3) * 8);
        int row = Rows.IndexOf(compact[letters + 2]);
        int digits = (compact.Length - letters - 3) / 2;
        if (zone is < 1 or > 60 || band < 0 || column is < 0 or > 7 || row < 0
            || !TryReadDigits(compact, letters + 3, digits, out int east)
            || !TryReadDigits(compact, letters + 3 + digits, digits, out int north))
            return false;

        int northing = (((row + (zone % 2 == 0 ? 15 : 0)) % 20) * Square) + north;
        while (northing < (MinNorthing[band] * Square))
            northing += RowCycle;
        var found = new MgrsPosition(zone, band, ((column + 1) * Square) + east, northing, digits);
        if (!found.IsInBand())
            return false;
        position = found;
        return true;
    }

    /// <summary>As 32TMT6500050000.</summary>
    public override string ToString()
    {
        if (Zone == 0)
            return "";
        char column = Columns[(((Zone + 2) % 3) * 8) + (_eastingMetres / Square) - 1];
        char row = Rows[((_northingMetres / Square) + (Zone % 2 == 0 ? 5 : 0)) % 20];
        string name = string.Concat(
            Zone.ToString("00", CultureInfo.InvariantCulture), Band.ToString(), column.ToString(), row.ToString());
        if (Digits == 0)
            return name;
        string format = "D" + Digits.ToString(CultureInfo.InvariantCulture);
        return name + (_eastingMetres % Square / WidthMetres).ToString(format, CultureInfo.InvariantCulture)
            + (_northingMetres % Square / WidthMetres).ToString(format, CultureInfo.InvariantCulture);
    }

    // The letters name a square of 100 km: it must have ground in its band, or they name none. Its southernmost and its
    // northernmost place are corners, since no square lies across the central meridian.
    private bool IsInBand()
    {
        double south = -80 + (8 * _band);
        double north = _band == UtmZones.Bands.Length - 1 ? 84 : south + 8;
        int west = _eastingMetres / Square * Square;
        int bottom = _northingMetres / Square * Square;
        double lowest = Math.Min(LatitudeAt(west, bottom), LatitudeAt(west + Square, bottom));
        double highest = Math.Max(LatitudeAt(west, bottom + Square), LatitudeAt(west + Square, bottom + Square));
        return lowest <= north && highest >= south;
    }

    private double LatitudeAt(int eastingMetres, int northingMetres)
        => new UtmPosition(Zone, _band >= 10, eastingMetres, northingMetres).ToGeographic().Latitude.Degrees;

    private static bool TryReadDigits(string text, int start, int digits, out int metres)
    {
        metres = 0;
        for (int i = start; i < start + digits; i++)
        {
            if (text[i] is < '0' or > '9')
                return false;
            metres = (10 * metres) + (text[i] - '0');
        }

        metres *= PowerOfTen(5 - digits);
        return true;
    }

    private static int PowerOfTen(int exponent)
    {
        int power = 1;
        for (int i = 0; i < exponent; i++)
            power *= 10;
        return power;
    }
}

using System;

namespace Rabit.Geodesy;

/// <summary>
/// Zones and bands of UTM (NGA.STND.0037, "Universal Grids and Grid Reference Systems", 2014). Degrees.
/// </summary>
internal static class UtmZones
{
    /// <summary>Letters of the bands of 8 degrees from 80 degrees south; the last one has 12.</summary>
    public const string Bands = "CDEFGHJKLMNPQRSTUVWX";

    /// <summary>The zone of a place, longitude -180 to 180.</summary>
    public static int Of(double latitude, double longitude)
    {
        int zone = ((int)Math.Floor((longitude + 180) / 6) % 60) + 1;
        if (latitude >= 56 && latitude < 64 && longitude >= 3 && longitude < 12)
            return 32;
        if (latitude < 72 || longitude < 0 || longitude >= 42)
            return zone;
        return longitude < 9 ? 31 : longitude < 21 ? 33 : longitude < 33 ? 35 : 37;
    }

    public static Angle CentralMeridian(int zone) => Angle.FromDegrees((6 * zone) - 183);

    /// <summary>Which of <see cref="Bands"/>.</summary>
    public static int BandOf(double latitude)
        => Math.Max(0, Math.Min(Bands.Length - 1, (int)Math.Floor((latitude + 80) / 8)));
}

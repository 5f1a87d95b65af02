using System;
using System.Globalization;
using System.Linq;

namespace Rabit.Vision;

/// <summary>
/// DJI's DewarpData: a date and nine numbers, "2018-09-28;fx,fy,cx,cy,k1,k2,p1,p2,k3", cx and cy from the middle.
/// </summary>
internal static class XmpLens
{
    private const int Numbers = 9;
    private const double MaxFocal = 1_000_000;

    public static string Write(PhotoLens lens, DateTime? calibrated)
    {
        double[] numbers =
        [
            lens.FocalX, lens.FocalY, lens.CentreOffsetX, lens.CentreOffsetY, lens.K1, lens.K2, lens.P1, lens.P2,
            lens.K3,
        ];
        return (calibrated ?? new DateTime(1970, 1, 1)).ToString("yyyy-MM-dd", CultureInfo.InvariantCulture) + ";"
            + string.Join(",", numbers.Select(n => n.ToString("0.#########", CultureInfo.InvariantCulture)));
    }

    /// <summary>Reads it; null for what is none.</summary>
    public static PhotoLens? Read(string text)
    {
        string[] parts = text.Substring(text.IndexOf(';') + 1).Split(',');
        double[] n = new double[Numbers];
        if (parts.Length != Numbers)
            return null;
        for (int i = 0; i < Numbers; i++)
        {
            if (!double.TryParse(parts[i], NumberStyles.Float, CultureInfo.InvariantCulture, out n[i])
                || !(Math.Abs(n[i]) <= MaxFocal))
                return null;
        }

        if (!(n[0] > 0 && n[1] > 0))
            return null;
        return new PhotoLens
        {
            FocalX = n[0],
            FocalY = n[1],
            CentreOffsetX = n[2],
            CentreOffsetY = n[3],
            K1 = n[4],
            K2 = n[5],
            P1 = n[6],
            P2 = n[7],
            K3 = n[8],
        };
    }
}

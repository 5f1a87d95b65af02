using System;
using System.Globalization;
using System.IO;

namespace Rabit.Uav.Web.Serving;

/// <summary>
/// Map tiles of a folder, ZOOM/X/Y.png. Numbers only become a path, so that no request leaves the folder.
/// </summary>
internal sealed class TileFolder(string folder)
{
    private const int MaxZoom = 22;

    /// <param name="path">"/17/68610/45900.png".</param>
    /// <returns>The file; null where there is none.</returns>
    public string? Find(string path)
    {
        string[] parts = path.Split('/');
        if (parts is not ["", var zoomText, var xText, var yText] || !yText.EndsWith(".png", StringComparison.Ordinal)
            || !TryParse(zoomText, out int zoom) || zoom > MaxZoom || !TryParse(xText, out int x)
            || !TryParse(yText[..^4], out int y) || x >> zoom != 0 || y >> zoom != 0)
            return null;
        string file = Path.Combine(
            folder, zoom.ToString(CultureInfo.InvariantCulture), x.ToString(CultureInfo.InvariantCulture),
            y.ToString(CultureInfo.InvariantCulture) + ".png");
        return File.Exists(file) ? file : null;
    }

    private static bool TryParse(string text, out int value)
        => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out value);
}

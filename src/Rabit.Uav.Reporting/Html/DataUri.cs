using System;
using Rabit.Vision;

namespace Rabit.Uav.Reporting.Html;

/// <summary>Pictures as addresses that need no network.</summary>
internal static class DataUri
{
    public static string Of(RgbPicture picture)
        => "data:image/png;base64," + Convert.ToBase64String(PngPicture.Encode(picture));
}

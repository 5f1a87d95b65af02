using System.Globalization;
using System.Linq;
using System.Text;

namespace Rabit.Uav.MissionControl;

/// <summary>SHA-256 of a text in UTF-8, as hexadecimal digits.</summary>
internal static partial class Sha256Hex
{
    public const int Length = 64;

    public static string Of(string text)
        => string.Concat(
            Hash(Encoding.UTF8.GetBytes(text)).Select(b => b.ToString("x2", CultureInfo.InvariantCulture)));
}

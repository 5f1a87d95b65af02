using System.Globalization;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using Rabit.Uav.MissionControl;

namespace UavConsole;

/// <summary>A mission and the file that it was read from. Immutable.</summary>
/// <param name="name">Of the file, without its folder.</param>
/// <param name="text">What is in it.</param>
/// <param name="plan">What that means.</param>
internal sealed class MissionFile(string name, string text, MissionPlan plan)
{
    public string Name { get; } = name;

    public MissionPlan Plan { get; } = plan;

    /// <summary>
    /// SHA-256 of the text in UTF-8, hexadecimal: what <c>sha256sum</c> says of a file without a byte order mark.
    /// </summary>
    public string Sha256 { get; } = HashOf(text);

    private static string HashOf(string text)
    {
        using var sha = SHA256.Create();
#pragma warning disable CA1850   // Mono has no HashData.
        byte[] hash = sha.ComputeHash(new UTF8Encoding(encoderShouldEmitUTF8Identifier: false).GetBytes(text));
#pragma warning restore CA1850
        return string.Concat(hash.Select(b => b.ToString("x2", CultureInfo.InvariantCulture)));
    }
}

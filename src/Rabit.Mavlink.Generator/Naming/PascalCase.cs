using System.Linq;
using System.Text;
using System.Text.RegularExpressions;

namespace Rabit.Mavlink.Generator.Naming;

/// <summary>
/// Names of definitions as C# writes them. Words are what stands between underscores; each begins with a capital. A
/// word without small letters becomes small after its first one (<c>GPS_RAW_INT</c>: GpsRawInt), a mixed word keeps its
/// capitals (<c>hRef_t</c>: HRefT). An underscore between two digits stays, since 1_1 is not 11.
/// </summary>
internal static class PascalCase
{
    // Names have nothing but letters, digits and underscores; a file name, which a dialect is called after, may have
    // more.
    public static string[] Words(string name)
        => Regex.Split(name, "[^A-Za-z0-9]+", RegexOptions.CultureInvariant).Where(word => word.Length != 0).ToArray();

    public static string Of(string name) => Join(Words(name));

    public static string Join(string[] words)
    {
        var text = new StringBuilder();
        foreach (string word in words)
        {
            if (text.Length != 0 && char.IsDigit(text[text.Length - 1]) && char.IsDigit(word[0]))
                text.Append('_');
            text.Append(char.ToUpperInvariant(word[0]));
            text.Append(word.Any(char.IsLower) ? word.Substring(1) : word.Substring(1).ToLowerInvariant());
        }

        // Only a name of nothing but underscores, or one that hides a digit behind them, has no letter in front.
        if (text.Length == 0 || char.IsDigit(text[0]))
            text.Insert(0, 'N');
        return text.ToString();
    }
}

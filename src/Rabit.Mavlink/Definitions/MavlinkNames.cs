using System.Globalization;
using System.Text;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// The names that MAVLink's documents and ground stations have for enumerators, for logs and texts: NAV_LAND, not
/// NavLand. Any thread; each call makes a new string.
/// </summary>
/// <example>
/// <code>
/// string text = MavlinkNames.Of(MavCmd.NavLand) + ": " + MavlinkNames.Of(MavResult.Denied);   // NAV_LAND: DENIED
/// </code>
/// </example>
public static class MavlinkNames
{
    /// <summary>
    /// The name of a command, without MAV_CMD_; of one that has no name its number. Of those of storm32.xml it begins
    /// with STORM_32 instead of STORM32.
    /// </summary>
    /// <param name="command">The command.</param>
    public static string Of(MavCmd command)
        => Of(command.ToString(), ((int)command).ToString(CultureInfo.InvariantCulture));

    /// <summary>The name of a result, without MAV_RESULT_; of one that has no name its number.</summary>
    /// <param name="result">The result.</param>
    public static string Of(MavResult result)
        => Of(result.ToString(), ((int)result).ToString(CultureInfo.InvariantCulture));

    // A word begins with a capital, and a number is one.
    private static string Of(string name, string number)
    {
        if (name == number)
            return number;
        var text = new StringBuilder(name.Length + 8);
        for (int i = 0; i < name.Length; i++)
        {
            bool isNumber = char.IsDigit(name[i]) && (i == 0 || !char.IsDigit(name[i - 1]));
            if (i > 0 && (isNumber || char.IsUpper(name[i])))
                text.Append('_');
            text.Append(char.ToUpperInvariant(name[i]));
        }

        return text.ToString();
    }
}

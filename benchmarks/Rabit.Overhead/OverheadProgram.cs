using System;
using System.Globalization;
using System.Threading.Tasks;

namespace Rabit.Overhead;

/// <summary>
/// What hosting, live page and diagnostics add to a flight in real time, as processor time of its process. The same
/// flight is flown by several processes at the same time, so that what else the machine does hits all of them alike.
/// </summary>
internal static class OverheadProgram
{
    /// <summary>The argument with which this program starts itself as the process that is measured.</summary>
    public const string Flight = "flight";

    public static async Task<int> Main(string[] args)
    {
        if (args is [Flight, var parts])
            return await new MeasuredFlight(Enum.Parse<Parts>(parts)).RunAsync();
        if (args.Length > 2 || !TryRead(args, 0, 5, out int rounds) || !TryRead(args, 1, 120, out int seconds))
        {
            Console.Error.WriteLine("Rabit.Overhead [ROUNDS [SECONDS]], 5 rounds of 120 s of flight without them");
            return 2;
        }

        await new Comparison(TimeSpan.FromSeconds(seconds)).RunAsync(rounds);
        return 0;
    }

    private static bool TryRead(string[] args, int index, int otherwise, out int value)
    {
        value = otherwise;
        return args.Length <= index
            || int.TryParse(args[index], NumberStyles.None, CultureInfo.InvariantCulture, out value) && value > 0;
    }
}

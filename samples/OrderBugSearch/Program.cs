using System;
using System.Globalization;
using System.Linq;
using OrderBugSearch;
using Rabit.Core;

// --seeds N          searches the seeds from 1 to N (1000 without it); exit code 1, and the seed, if one fails
// --seed N           runs this one and prints its event log
// ... --fixed        the same after the bug was fixed
bool isFixed = args.Contains("--fixed", StringComparer.Ordinal);
string[] rest = args.Where(a => !string.Equals(a, "--fixed", StringComparison.Ordinal)).ToArray();
if (rest.Length == 0)
    return Search(1000);
if (rest.Length == 2 && int.TryParse(rest[1], NumberStyles.None, CultureInfo.InvariantCulture, out int number)
    && number > 0)
{
    if (string.Equals(rest[0], "--seeds", StringComparison.Ordinal))
        return Search(number);
    if (string.Equals(rest[0], "--seed", StringComparison.Ordinal))
        return Replay(number);
}

Console.Error.WriteLine(
    $"OrderBugSearch: '{string.Join(" ", args)}' is not [--seeds N | --seed N] [--fixed], with N above zero.");
return 2;

int Search(int seeds)
{
    FailingSeed? found = SeedSearch.Find(firstSeed: 1, seeds, time => PumpHouse.Run(time, isFixed));
    Console.WriteLine(
        found is null
            ? $"all seeds from 1 to {seeds} pass"
            : $"{found}\nsee how: dotnet run --project samples/OrderBugSearch -- --seed {found.Seed}");
    return found is null ? 0 : 1;
}

int Replay(int seed)
{
    try
    {
        PumpHouse.Run(new VirtualTime(seed) { EventLog = Console.Out }, isFixed);
        Console.WriteLine($"seed {seed} passes");
        return 0;
    }
    catch (PumpHouseException e)
    {
        Console.WriteLine($"seed {seed} fails: {e.Message}");
        return 1;
    }
}

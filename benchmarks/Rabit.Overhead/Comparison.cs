using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using System.Threading.Tasks;

namespace Rabit.Overhead;

/// <summary>
/// Rounds of flights side by side. Of each round and each process: the part of a core that it took after the warm-up,
/// in which code is compiled, and that part less what the flight alone took at the same time.
/// </summary>
internal sealed class Comparison(TimeSpan measured)
{
    private static readonly TimeSpan WarmUp = TimeSpan.FromSeconds(40);
    private static readonly Parts[] Variants =
        [Parts.None, Parts.Hosting, Parts.Page, Parts.Tool, Parts.All, Parts.TwentyBrowsers];

    private readonly Dictionary<Parts, List<double>> _taken = Variants.ToDictionary(v => v, _ => new List<double>());

    public async Task RunAsync(int rounds)
    {
        for (int round = 0; round < rounds; round++)
        {
            Print($"round {round + 1} of {rounds}");
            await RunRoundAsync(round);
        }

        Print("");
        Print("| | % of a core, mean | lowest to highest | added, mean | added, lowest to highest |");
        Print("|---|---:|---:|---:|---:|");
        foreach (Parts variant in Variants)
            Print(Row(variant));
    }

    private static void Print(string line) => Console.WriteLine(line);

    private static string Number(double value) => value.ToString("0.00", CultureInfo.InvariantCulture);

    private static string Range(IReadOnlyCollection<double> values)
        => $"{Number(values.Min())} to {Number(values.Max())}";

    // Each round begins with another variant: who starts first has an advantage.
    private async Task RunRoundAsync(int round)
    {
        FlightProcess[] flights =
            [.. Variants.Select((_, i) => new FlightProcess(Variants[(i + round) % Variants.Length]))];
        try
        {
            foreach (FlightProcess flight in flights)
                await flight.ConnectAsync();
            await Task.Delay(WarmUp);
            double[] before = [.. flights.Select(f => f.ProcessorSeconds)];
            var watch = Stopwatch.StartNew();
            await Task.Delay(measured);
            double seconds = watch.Elapsed.TotalSeconds;
            foreach ((FlightProcess flight, double start) in flights.Zip(before))
            {
                double percent = 100 * (flight.ProcessorSeconds - start) / seconds;
                _taken[flight.Parts].Add(percent);
                Print($"  {flight.Parts}: {Number(percent)} % of a core; received from its page {flight.Bytes.Page}, from its diagnostics {flight.Bytes.Tool} bytes");
            }
        }
        finally
        {
            foreach (FlightProcess flight in flights)
                flight.Dispose();
        }
    }

    private string Row(Parts variant)
    {
        List<double> taken = _taken[variant];
        double[] added = [.. taken.Zip(_taken[Parts.None], (all, alone) => all - alone)];
        string first = $"| {variant} | {Number(taken.Average())} | {Range(taken)} |";
        return variant == Parts.None ? first + " | |" : $"{first} {Number(added.Average())} | {Range(added)} |";
    }
}

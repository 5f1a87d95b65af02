using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Tests.Shared;

namespace Rabit.Uav.Simulation.Tests.Energy;

/// <summary>Writes docs/energy-trial.md, where RABIT_UPDATE_DOCS=1 asks for it.</summary>
internal static class EnergyTrialDocument
{
    private const string Introduction =
        """
        # Energy trial

        Searches that are longer than the battery lasts, by all six managers in the simulation, without pictures; each drawn by its seed (`EnergyCase` in
        tests/Rabit.Uav.Simulation.Tests/Energy): the middle of the area 0.3 to 4.7 km from home in any direction, 8 to 12 m/s, wind to 10 m/s from any direction, in every third flight after a rise by
        5 m/s within the first 3 minutes, 80 to 100 % of the stated capacity (the autopilot counts its percentage from the stated one), 70 to 100 % charged. Each is begun with `allowPartialSearch`.
        Required: every flight lands within 3 m of home with at least 5 % of its true charge; where energy ended the search, at most 25 % are left in the mean.

        `RABIT_UPDATE_DOCS=1 dotnet test -s tests/long.runsettings tests/Rabit.Uav.Simulation.Tests --filter FullyQualifiedName~EnergyTrial` flies it and writes this page. The vehicle of the
        simulation holds an airspeed of 18 m/s, which is given as the prior; the limit of the wind of Health Monitoring is raised to 18 m/s, so that no gust ends a flight before its energy does.

        The uncertainties of the model were chosen with seeds 1 to 60. These seeds were not flown before that, and nothing was changed after they were. `RABIT_ENERGY_SEED=N` flies 60 others, from N on.

        """;

    public static double MeanLeft(IReadOnlyList<EnergyFlight> flights)
        => flights.Where(f => f.WasEndedByEnergy).Average(f => f.Truth.BatteryRemaining);

    public static string Summary(IReadOnlyList<EnergyFlight> flights, TimeSpan took)
        => FormattableString.Invariant(
            $"{flights.Count} flights, {flights.Count(f => f.WasEndedByEnergy)} ended by energy with {100 * MeanLeft(flights):0.0} % left in the mean; least {100 * flights.Min(f => f.Truth.BatteryRemaining):0.0} %, farthest landing {flights.Max(f => f.LandingDistance):0.0} m from home; at commit {Environment.GetEnvironmentVariable("RABIT_COMMIT") ?? "unknown"}, in {took.TotalSeconds:0} s on {Environment.ProcessorCount} cores.");

    public static void Update(IReadOnlyList<EnergyFlight> flights, TimeSpan took)
    {
        if (Environment.GetEnvironmentVariable("RABIT_UPDATE_DOCS") != "1")
            return;
        var text = new StringBuilder(Introduction.Replace("\r\n", "\n"));
        text.Append(Summary(flights, took)).Append("\n\n");
        text.Append("| seed | autopilot | area km | speed m/s | wind m/s | rises at s | capacity % | charge % | ")
            .Append("returned from km | truly left % | estimated % | way home % | landed m | left % | flown min |\n")
            .Append("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
        foreach (EnergyFlight f in flights)
            WriteRow(text, f);
        File.WriteAllText(Path.Combine(Repository.Root, "docs", "energy-trial.md"), text.ToString());
    }

    private static void WriteRow(StringBuilder text, EnergyFlight f)
    {
        EnergyCase c = f.Case;
        string rises = c.RisesAt is { } at ? FormattableString.Invariant($"{at.TotalSeconds:0}") : "-";
        text.Append(FormattableString.Invariant(
            $"| {c.Seed} | {c.Model} | {c.Distance / 1000:0.0} | {c.Speed:0.0} | {c.Wind:0.0} | {rises} | {100 * c.Capacity:0} | {100 * c.Charge:0} "));
        text.Append(FormattableString.Invariant(
            $"| {f.DistanceAtReturn / 1000:0.0} | {100 * f.LeftAtReturn:0} | {100 * f.AtReturn.ChargeLeft:0} +- {100 * f.AtReturn.ChargeLeftDeviation:0} | {100 * f.AtReturn.ChargeHome:0} +- {100 * f.AtReturn.ChargeHomeDeviation:0} "));
        text.Append(FormattableString.Invariant(
            $"| {f.LandingDistance:0.0} | {100 * f.Truth.BatteryRemaining:0.0} | {f.Truth.Airtime.TotalMinutes:0.0} |\n"));
    }
}

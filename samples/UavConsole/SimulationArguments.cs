using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Linq;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>The options of the command line that say what the simulated world is like.</summary>
internal static class SimulationArguments
{
    private static readonly Option<string> Gimbal = new("--gimbal")
    {
        Description = "What holds the simulated camera: body (it rolls and pitches with the vehicle), heading "
            + "(stabilised, follows the heading) or north (stabilised, keeps its direction). body without it.",
        HelpName = "NAME",
    };

    static SimulationArguments() => Gimbal.AcceptOnlyFromAmong("body", "heading", "north");

    public static IEnumerable<Option> All => [Gimbal];

    /// <summary>Puts what was asked for into the options of the world.</summary>
    public static SimulatedLook Read(ParseResult result) => new()
    {
        Gimbal = result.GetValue(Gimbal) switch
        {
            "heading" => SimulatedGimbal.FollowsHeading,
            "north" => SimulatedGimbal.HoldsNorth,
            _ => SimulatedGimbal.AgainstBody,
        },
    };

    public static IEnumerable<string> FindFaults(ParseResult result, Given given)
        => given.IsSimulated
            ? []
            : All.Where(o => result.GetResult(o) is { Implicit: false })
                .Select(o => $"{o.Name} is for the simulation; it does not go with --link.");
}

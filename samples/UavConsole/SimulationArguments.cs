using System;
using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Linq;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>The options of the command line that say what the simulated world is like.</summary>
internal static class SimulationArguments
{
    private const int MaxTargets = 50;

    private static readonly Option<string> Gimbal = new("--gimbal")
    {
        Description = "What holds the simulated camera: body (it rolls and pitches with the vehicle), heading "
            + "(stabilised, follows the heading) or north (stabilised, keeps its direction). The mission points a "
            + "stabilised one, at a moving target while it is followed. body without it.",
        HelpName = "NAME",
    };

    private static readonly Option<string> Effects = new("--picture-effects")
    {
        Description = "What makes the simulated pictures worse, motion blur, clouds, a wrong white balance and JPEG "
            + "among it: none, moderate or harsh. none without it.",
        HelpName = "NAME",
    };

    private static readonly Option<SimulatedTargetKind[]> TargetKinds = new("--target-kinds")
    {
        Description = "What the simulated targets are, in turn, by commas: " + SimulatedTargetKindNames.All + ". "
            + "The mission also searches for their classes. coloured without it.",
        HelpName = "NAMES",
        CustomParser = ParseKinds,
        AllowMultipleArgumentsPerToken = false,
    };

    private static readonly Option<int?> PartlyHidden = new("--partly-hidden")
    {
        Description = "How many of the simulated targets, the first that are no markers, are overgrown by a fifth to "
            + $"two fifths, 0 to {MaxTargets}. 0 without it.",
        HelpName = "N",
        CustomParser = ParseCount,
    };

    private static readonly Option<int?> Occluders = new("--occluders")
    {
        Description = "How many trees and roofs of the simulated world hide what is below them from the camera, 0 to "
            + $"{MaxTargets}: over the ways of the targets that move, or anywhere where none does. 0 without it.",
        HelpName = "N",
        CustomParser = ParseCount,
    };

    static SimulationArguments()
    {
        Gimbal.AcceptOnlyFromAmong("body", "heading", "north");
        Effects.AcceptOnlyFromAmong("none", "moderate", "harsh");
    }

    public static IEnumerable<Option> All => [Gimbal, TargetKinds, PartlyHidden, Occluders, Effects];

    /// <summary>Puts what was asked for into the options of the world.</summary>
    public static SimulatedLook Read(ParseResult result) => new()
    {
        Gimbal = result.GetValue(Gimbal) switch
        {
            "heading" => SimulatedGimbal.FollowsHeading,
            "north" => SimulatedGimbal.HoldsNorth,
            _ => SimulatedGimbal.AgainstBody,
        },
        Effects = result.GetValue(Effects),
        TargetKinds = result.GetValue(TargetKinds) ?? [],
        PartlyHidden = result.GetValue(PartlyHidden) ?? 0,
        Occluders = result.GetValue(Occluders) ?? 0,
    };

    public static IEnumerable<string> FindFaults(ParseResult result, Given given)
        => given.IsSimulated
            ? []
            : All.Where(o => result.GetResult(o) is { Implicit: false })
                .Select(o => $"{o.Name} is for the simulation; it does not go with --link.");

    private static SimulatedTargetKind[] ParseKinds(ArgumentResult result)
    {
        var kinds = new List<SimulatedTargetKind>();
        foreach (string name in result.Tokens.SelectMany(t => t.Value.Split(',')))
        {
            if (SimulatedTargetKindNames.TryParse(name, out SimulatedTargetKind kind))
                kinds.Add(kind);
            else
                result.AddError(SimulatedTargetKindNames.Fault("--target-kinds", name));
        }

        return kinds.ToArray();
    }

    private static int? ParseCount(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int count) && count <= MaxTargets)
            return count;
        result.AddError($"{((OptionResult)result.Parent!).Option.Name} {text}: it must be a number from 0 to {MaxTargets}.");
        return null;
    }
}

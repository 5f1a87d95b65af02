using System;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Linq;
using Rabit.Links;
using Rabit.Tool.Simulation;
using Rabit.Uav.Communications;
using Rabit.Uav.Simulation;

namespace Rabit.Tool.Commands;

/// <summary><c>rabit simulate</c>: a vehicle for any MAVLink program.</summary>
internal static class SimulateCommand
{
    private const double MaxWind = 25;
    private const int MaxTargets = 1000;

    public static Command Create()
    {
        var defaults = new SimulationOptions();
        var link = new Option<LinkUrl>("--link", "-l")
        {
            Description = "udpout:HOST:PORT, udpin:ADDRESS:PORT, udpbcast:ADDRESS:PORT, tcp:HOST:PORT, "
                + "tcpin:ADDRESS:PORT or serial:DEVICE:BAUD: where the vehicle sends its telemetry and takes commands.",
            HelpName = "URL",
            CustomParser = ParseLink,
            DefaultValueFactory = _ => LinkUrl.Parse("udpout:127.0.0.1:14550"),
        };
        var seed = new Option<long>("--seed")
        {
            Description = "All that is left to chance follows from it.",
            HelpName = "N",
            CustomParser = result => ParseNumber(result, "--seed", long.MinValue, long.MaxValue),
            DefaultValueFactory = _ => defaults.Seed,
        };
        var targets = new Option<int>("--targets")
        {
            Description = "How many targets lie in the area.",
            HelpName = "N",
            CustomParser = result => (int)ParseNumber(result, "--targets", 0, MaxTargets),
            DefaultValueFactory = _ => defaults.TargetCount,
        };
        var kinds = new Option<SimulatedTargetKind[]>("--target-kinds")
        {
            Description = "What the targets are, in turn, by commas: " + SimulatedTargetKindNames.All
                + ". coloured without it.",
            HelpName = "NAMES",
            CustomParser = ParseKinds,
            AllowMultipleArgumentsPerToken = false,
            DefaultValueFactory = _ => [],
        };
        var hidden = new Option<int>("--partly-hidden")
        {
            Description = "How many of the targets, the first that are no markers, are overgrown in part.",
            HelpName = "N",
            CustomParser = result => (int)ParseNumber(result, "--partly-hidden", 0, MaxTargets),
            DefaultValueFactory = _ => 0,
        };
        var wind = new Option<double>("--wind")
        {
            Description = "Mean wind in m/s, 0 to 25.",
            HelpName = "M/S",
            CustomParser = ParseWind,
            DefaultValueFactory = _ => defaults.WindMetresPerSecond,
        };
        var mission = new Option<string>("--mission")
        {
            Description = "Takes home and the area of the targets from a mission file.",
            HelpName = "FILE"
        };
        var truth = new Option<string>("--truth-out")
        {
            Description = "Writes where the targets are, and at the end what the vehicle really did, as JSON.",
            HelpName = "FILE",
        };
        var camera = new Option<string>("--camera-out")
        {
            Description = "Writes the pictures of the vehicle's camera to a folder, for UavConsole --camera.",
            HelpName = "DIR",
        };

        var signKey = new Option<string>("--sign-key")
        {
            Description = "Signs what the vehicle sends with the key in a file, 32 bytes or 64 hexadecimal digits, and "
                + "rejects what is not signed with it.",
            HelpName = "FILE",
        };

        var autopilot = new Option<SimulatedAutopilot>("--autopilot")
        {
            Description = "ardupilot or px4: which autopilot the vehicle flies with.",
            HelpName = "NAME",
            CustomParser = ParseAutopilot,
            DefaultValueFactory = _ => defaults.Autopilot,
        };

        var systemId = new Option<byte>("--system-id")
        {
            Description = "The MAVLink system id of the vehicle, 1 to 254: several on one net have different ones.",
            HelpName = "N",
            CustomParser = result => (byte)ParseNumber(result, "--system-id", 1, 254),
            DefaultValueFactory = _ => defaults.SystemId,
        };

        var group = new Option<int>("--group")
        {
            Description = "It is one of N vehicles that stand side by side in the world of the seed, 2 to "
                + $"{SimulatedGroupOptions.MaxVehicles}, each in a process of its own; --system-id, 1 to N, says which.",
            HelpName = "N",
            CustomParser = result => (int)ParseNumber(result, "--group", 2, SimulatedGroupOptions.MaxVehicles),
            DefaultValueFactory = _ => 1,
        };

        autopilot.CompletionSources.Clear();   // the names of the enumeration
        autopilot.CompletionSources.Add("ardupilot", "px4");
        link.CompletionSources.Add("udpout:", "udpin:", "udpbcast:", "tcp:", "tcpin:", "serial:");
        var command = new Command(
            "simulate",
            "A simulated multirotor in real time that speaks MAVLink as ArduPilot's Copter or PX4 does, until Ctrl-C.")
        {
            link, systemId, group, autopilot, seed, targets, kinds, hidden, wind, mission, camera, truth, signKey,
        };
        command.SetAction(result => VehicleRun.Run(new VehicleOptions(
            result.GetValue(link)!,
            new SimulationOptions
            {
                SystemId = result.GetValue(systemId),
                Autopilot = result.GetValue(autopilot),
                Seed = result.GetValue(seed),
                TargetCount = result.GetValue(targets),
                TargetKinds = result.GetValue(kinds)!,
                PartlyHiddenCount = result.GetValue(hidden),
                WindMetresPerSecond = result.GetValue(wind),
            },
            result.GetValue(mission),
            result.GetValue(truth),
            result.GetValue(camera),
            result.GetValue(signKey),
            result.GetValue(group)), result.InvocationConfiguration));
        return command;
    }

    private static LinkUrl? ParseLink(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (!LinkUrl.TryParse(text, out LinkUrl? url, out string? error))
            result.AddError(error!);
        else if (url!.Kind == LinkKind.RecordedFile)
            result.AddError($"--link {text}: a recorded flight cannot be flown; it must be a live link.");
        else
            return url;
        return null;
    }

    private static SimulatedAutopilot ParseAutopilot(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (string.Equals(text, "px4", StringComparison.OrdinalIgnoreCase))
            return SimulatedAutopilot.Px4;
        if (!string.Equals(text, "ardupilot", StringComparison.OrdinalIgnoreCase))
            result.AddError($"--autopilot {text}: it must be ardupilot or px4.");
        return SimulatedAutopilot.ArduPilot;
    }

    private static SimulatedTargetKind[] ParseKinds(ArgumentResult result)
    {
        string[] names = result.Tokens.SelectMany(t => t.Value.Split(',')).ToArray();
        foreach (string name in names.Where(n => !SimulatedTargetKindNames.TryParse(n, out _)))
            result.AddError(SimulatedTargetKindNames.Fault("--target-kinds", name));
        return Array.ConvertAll(
            names, n => SimulatedTargetKindNames.TryParse(n, out SimulatedTargetKind kind) ? kind : default);
    }

    private static long ParseNumber(ArgumentResult result, string option, long low, long high)
    {
        string text = result.Tokens[0].Value;
        if (long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long number)
            && number >= low && number <= high)
            return number;
        result.AddError(
            $"{option} {text}: it must be a whole number" + (low == long.MinValue ? "." : $" from {low} to {high}."));
        return 0;
    }

    private static double ParseWind(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double speed)
            && speed <= MaxWind)
            return speed;
        result.AddError($"--wind {text}: it must be a number of m/s from 0 to 25.");
        return 0;
    }
}

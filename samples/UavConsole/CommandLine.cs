using System;
using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Links;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>Reads the command line. Everything wrong with it is one line and exit code 2.</summary>
internal static class CommandLine
{
    private const int BadInput = 2;
    private const int MaxTargets = 50;
    private const int DefaultTargets = 5;

    private static readonly Option<LinkUrl[]> Links = new("--link", "-l")
    {
        Description = "A real vehicle or a recorded flight instead of the simulation: udpin:ADDRESS:PORT, "
            + "udpout:HOST:PORT, udpbcast:ADDRESS:PORT, tcp:HOST:PORT, tcpin:ADDRESS:PORT, serial:DEVICE:BAUD "
            + "or tlog:FILE[?speed=10|max], with options behind, for example ,name=radio,optional "
            + "(docs/concepts/links.md); may be given several times. A vehicle is only observed, unless --mission "
            + "FILE --fly is given.",
        HelpName = "URL",
        CustomParser = ParseLinks,
        AllowMultipleArgumentsPerToken = false,
    };

    private static readonly Option<bool> RealTime = new("--realtime")
    {
        Description = "The simulation at the pace of a real flight, not as fast as the machine goes."
    };

    private static readonly Option<long?> Seed = new("--seed")
    {
        Description = "Of the simulated world, 0 or more; the same seed is the same flight. 1 without it.",
        HelpName = "N",
        CustomParser = ParseSeed,
    };

    private static readonly Option<int?> Targets = new("--targets")
    {
        Description = $"How many targets the simulated world has, 0 to {MaxTargets}. 5 without it.",
        HelpName = "N",
        CustomParser = ParseTargets,
    };

    private static readonly Option<int?> Moving = new("--moving")
    {
        Description = "How many of the simulated targets move: the first walks, the next is a vehicle, the next moves "
            + "erratically, and so on. The mission declares their classes as moving. 0 without it.",
        HelpName = "N",
        CustomParser = ParseTargets,
    };

    private static readonly Option<string> Autopilot = new("--autopilot")
    {
        Description = "What the simulated vehicle flies with: ardupilot or px4. ardupilot without it.",
        HelpName = "NAME",
    };

    private static readonly Option<string> Mission = new("--mission")
    {
        Description = "What to fly (docs/mission-file.md). Without it the simulation flies a bundled one.",
        HelpName = "FILE",
    };

    private static readonly Option<bool> Fly = new("--fly")
    {
        Description = "Commands the vehicle at the other end of --link: arms it and flies --mission; needs both, and "
            + "--camera or --without-detection."
    };

    private static readonly Option<string> Camera = new("--camera")
    {
        Description = "A camera for a live --link, which it needs: a folder of pictures with their times, also a "
            + "growing one, or a file in the form of its camera.json, whose source may be a program "
            + "(docs/camera-folder.md).",
        HelpName = "DIR",
    };

    private static readonly Option<string> Terrain = new("--terrain")
    {
        Description = "Heights of the ground, an ARC/INFO ASCII grid in degrees, above mean sea level: the mission "
            + "keeps its heights above it, and targets are located on it (docs/mission-file.md); needs --fly.",
        HelpName = "FILE"
    };

    private static readonly Option<string> TruthOption = new("--truth")
    {
        Description = "Where the targets really are, to score those found over --link; needs --fly.",
        HelpName = "FILE"
    };

    private static readonly Option<bool> Headless = new("--headless")
    {
        Description = "Plain lines instead of a live screen; by itself where the output is no terminal."
    };

    private static readonly Option<string> Summary = new("--summary")
    {
        Description = "Writes the summary as JSON too (docs/uavconsole-summary.md); of one vehicle, not with --vehicles.",
        HelpName = "FILE"
    };

    private static readonly Option<string> Report = new("--report")
    {
        Description = "Where the report of the flight goes, one page of HTML. MISSION-DATE-report.html for a mission "
            + "without it, none for other runs. A file that is there is kept beside it, under its date.",
        HelpName = "FILE",
    };

    private static readonly Option<string> Log = new("--log")
    {
        Description = "Writes the log of the run, a line for each entry.",
        HelpName = "FILE"
    };

    private static readonly Option<string> SignKey = new("--sign-key")
    {
        Description = "Signs and verifies MAVLink on all live links with the key in a file, 32 bytes or 64 hexadecimal "
            + "digits (docs/concepts/signing.md). FILE.clock.0 and .1 beside it keep "
            + "the time of the signatures.",
        HelpName = "FILE",
    };

    private static readonly Option<int[]> TrustLink = new("--trust-link")
    {
        Description = "A link that is not signed with --sign-key: a cable. Its number, from 0 in the order of the live "
            + "--link; may be given several times.",
        HelpName = "N",
    };

    private static readonly Option<byte?> SystemId = new("--system-id")
    {
        Description = "Our MAVLink system id, 1 to 255, and so that of the vehicle that carries us; without it that of "
            + "the first autopilot that is received.",
        HelpName = "N",
        CustomParser = ParseSystemId,
    };

    private static readonly Option<string> Px4Events = new("--px4-events")
    {
        Description = "The texts of PX4's events: all_events.json of its build, or 'fetch' to read them from the "
            + "autopilot, which has them unless they are compressed with xz. Without it an event is its number, level "
            + "and arguments in the log. Needs --link.",
        HelpName = "FILE",
    };

    static CommandLine() => Autopilot.AcceptOnlyFromAmong("ardupilot", "px4");

    /// <summary>Reads a command line and does what it asks for.</summary>
    /// <param name="arguments">As the program got them.</param>
    /// <param name="errors">Where a fault is written: one line.</param>
    /// <param name="run">Gets what was asked for, and where it writes faults; returns the exit code.</param>
    /// <returns>The exit code.</returns>
    public static int Run(string[] arguments, TextWriter errors, Func<ConsoleOptions, TextWriter, int> run)
    {
        ParseResult parsed = Create(errors, run).Parse(arguments);
        return parsed.Errors.Count > 0
            ? Refuse([.. parsed.Errors.Select(e => e.Message), "(--help shows the options)"], errors)
            : parsed.Invoke(new InvocationConfiguration { Error = errors });
    }

    /// <summary>The command, with all its options.</summary>
    /// <param name="errors">Where a fault is written: one line.</param>
    /// <param name="run">As for <see cref="Run"/>.</param>
    public static RootCommand Create(TextWriter errors, Func<ConsoleOptions, TextWriter, int> run)
    {
        var command = new RootCommand(
            "Rabit's managers fly a search: a simulated one, or with a real vehicle; or they observe a flight, live or "
                + "recorded.")
        {
            Links, RealTime, Seed, Targets, Moving, GroupArguments.Vehicles, GroupArguments.Layer,
            GroupArguments.LayerSpacing, GroupArguments.Commands, Autopilot, Mission, Fly, Camera, Terrain,
            TruthOption, Headless, Summary, Report, Log, SystemId, SignKey, TrustLink, Px4Events,
        };
        foreach (Option option in PreflightArguments.All.Concat(OperatorArguments.All)
            .Concat(ReportArguments.All).Concat(RecordingArguments.All).Concat(KeepArguments.Options)
            .Concat(AbandonedArguments.All)
            .Concat(WebArguments.All).Concat(ConfigArguments.All).Concat(SimulationArguments.All))
            command.Add(option);
        command.SetAction(result =>
        {
            var faults = new List<string>();
            Given given = Merge(result, faults);
            if (faults.Count == 0)
                faults.AddRange(FindFaults(result, given));
            return faults.Count > 0 ? Refuse(faults, errors) : run(Read(result, given), errors);
        });
        return command;
    }

    // Says what is wrong, on one line.
    private static int Refuse(IEnumerable<string> faults, TextWriter errors)
    {
        string line = string.Join(" ", faults).Replace("\r", string.Empty).Replace("\n", " ");
        FaultLine.WriteWhole(errors, line);
        return BadInput;
    }

    // Of the command line, and of the configuration file what that does not say.
    private static Given Merge(ParseResult result, List<string> faults)
    {
        LinkUrl[] links = result.GetValue(Links) ?? [];
        (Option, string)[] replaced =
        [
            (Links, "Links"), (Mission, "Mission"), (Camera, "Camera"), (Terrain, "Terrain"), (SignKey, "Signing"),
            (TrustLink, "Signing:TrustedLinks"), (SystemId, "SystemId"),
        ];
        ConfigFile? config = ConfigArguments.Read(result, replaced.Concat(OperatorArguments.Replaced), links, faults);
        bool mayCommand = config?.Options.MayCommand == true && !result.GetValue(Fly);
        return new Given
        {
            Config = config,
            Links = config?.Options.Links ?? links,
            Flies = mayCommand
                ? new Setting<bool>(true, config!.NameOf("MayCommand"))
                : new Setting<bool>(result.GetValue(Fly), Fly.Name),
            Mission = Given.TextOf(result.GetValue(Mission), Mission.Name, config, "Mission"),
            Camera = Given.TextOf(result.GetValue(Camera), Camera.Name, config, "Camera"),
            Terrain = Given.TextOf(result.GetValue(Terrain), Terrain.Name, config, "Terrain"),
            SignKey = Given.TextOf(result.GetValue(SignKey), SignKey.Name, config, "Signing:KeyFile"),
            TrustedLinks = result.GetValue(TrustLink) is { Length: > 0 } trusted
                ? trusted
                : Given.TrustedLinksOf(config),
            IsWithoutDetection = PreflightArguments.IsWithoutDetection(result, config),
        };
    }

    private static ConsoleOptions Read(ParseResult result, Given given) => new()
    {
        Config = given.Config,
        Links = given.Links,
        IsHeadless = result.GetValue(Headless) || !LiveScreen.IsPossible(),
        IsRealTime = result.GetValue(RealTime),
        Seed = result.GetValue(Seed) ?? (given.Config?.TextOf("Seed") is null ? 1 : given.Config.Options.Seed),
        TargetCount = result.GetValue(Targets) ?? DefaultTargets,
        MovingCount = result.GetValue(Moving) ?? 0,
        Look = SimulationArguments.Read(result),
        Vehicles = GroupArguments.Read(result),
        Group = GroupArguments.ReadGroup(result),
        LayerSpacingMetres = result.GetValue(GroupArguments.LayerSpacing),
        Commands = result.GetValue(GroupArguments.Commands) ?? [],
        Autopilot = result.GetValue(Autopilot) == "px4" ? SimulatedAutopilot.Px4 : SimulatedAutopilot.ArduPilot,
        MissionFile = given.Mission.Value,
        MissionOption = given.Mission.Name,
        Flies = given.Flies.Value,
        Camera = given.Camera.Value,
        TerrainFile = given.Terrain.Value,
        TruthFile = result.GetValue(TruthOption),
        SummaryFile = result.GetValue(Summary),
        ReportFile = result.GetValue(Report),
        LogFile = result.GetValue(Log),
        SystemId = result.GetValue(SystemId) ?? given.Config?.Options.SystemId,
        SignKeyFile = given.SignKey.Value,
        TrustedLinks = given.TrustedLinks,
        Px4EventsFile = result.GetValue(Px4Events),
        Preflight = PreflightArguments.Read(result, given.Config),
        Operator = OperatorArguments.Read(result, given.Flies.Value, given.Config),
        Reporting = ReportArguments.Read(result),
        Recording = RecordingArguments.Read(result, given.Config),
        KeptPictures = KeepArguments.Read(result, given.Config),
        AbandonedStateFile = AbandonedArguments.Read(result),
        Web = WebArguments.Read(result),
        CommandLine = string.Join(" ", new[] { "UavConsole" }.Concat(result.Tokens.Select(t => t.Value))),
    };

    // What makes no sense together. What is wrong with the options one by one has been said before.
    private static IEnumerable<string> FindFaults(ParseResult result, Given given)
        => (given.IsSimulated ? WithoutLink(result, given) : WithLink(result, given))
            .Concat(OfSigning(result, given))
            .Concat(RecordingArguments.FindFaults(result, given.IsReplay))
            .Concat(KeepArguments.FindFaults(result, given.IsReplay))
            .Concat(PreflightArguments.FindFaults(result, given))
            .Concat(OperatorArguments.FindFaults(result, given))
            .Concat(AbandonedArguments.FindFaults(
                result, !given.IsSimulated && !given.IsReplay, given.Flies.Value))
            .Concat(WebArguments.FindFaults(result))
            .Concat(GroupArguments.FindFaults(result, given))
            .Concat(SimulationArguments.FindFaults(result, given));

    private static IEnumerable<string> WithoutLink(ParseResult result, Given given)
    {
        if (result.GetValue(Fly))
            yield return "--fly commands a real vehicle: it needs --link URL and --mission FILE; the simulation flies "
                + "without it.";
        if (result.GetValue(Moving) > (result.GetValue(Targets) ?? DefaultTargets))
            yield return "--moving is more than there are targets (--targets).";
        if (given.Camera.Value is not null)
            yield return given.Camera.Name + " needs --link URL: the simulation has a camera of its own.";
        if (given.Terrain.Value is not null)
            yield return given.Terrain.Name + " needs --link URL: the ground of the simulation is level.";
        if (result.GetValue(TruthOption) is not null)
            yield return "--truth needs --link URL: the simulation knows its own truth.";
        if (result.GetValue(Px4Events) is not null)
            yield return "--px4-events needs --link URL: the events are those of a real autopilot, or of its log.";
    }

    private static IEnumerable<string> WithLink(ParseResult result, Given given)
    {
        if (result.GetValue(Seed) is not null)
            yield return "--seed is for the simulation; it does not go with --link.";
        if (result.GetValue(Targets) is not null)
            yield return "--targets is for the simulation; it does not go with --link.";
        if (result.GetValue(Moving) is not null)
            yield return "--moving is for the simulation; it does not go with --link.";
        if (result.GetValue(Autopilot) is not null)
            yield return "--autopilot is for the simulation; the one at the other end of --link says what it is.";
        if (result.GetValue(RealTime))
            yield return "--realtime is for the simulation; with --link a flight has its own pace, a recorded one by "
                + "?speed=.";
        if (given.Flies.Value && given.Mission.Value is null)
            yield return given.Flies.Name + " needs --mission FILE: what to fly.";
        if (result.GetValue(TruthOption) is not null && !given.Flies.Value)
            yield return "--truth scores a mission: it needs --mission FILE --fly.";
        if (result.GetValue(Terrain) is not null && !given.Flies.Value)
            yield return "--terrain gives a mission its heights: it needs --mission FILE --fly.";
        foreach ((string name, bool isGiven) in new[]
        {
            (given.Flies.Name, given.Flies.Value),
            (given.Mission.Name, given.Mission.Value is not null),
            (given.Camera.Name, given.Camera.Value is not null)
        })
        {
            if (given.IsReplay && isGiven)
                yield return $"{name} needs a live vehicle: a recorded flight is only replayed.";
        }
    }

    private static IEnumerable<string> OfSigning(ParseResult result, Given given)
    {
        if (result.GetValue(TrustLink) is { Length: > 0 } && given.SignKey.Value is null)
            yield return "--trust-link needs --sign-key FILE: without it no link is signed.";
        if (given.SignKey.Value is not null && given.IsReplay)
            yield return given.SignKey.Name + " needs a live vehicle: a recorded flight is only replayed.";
    }

    private static LinkUrl[] ParseLinks(ArgumentResult result)
    {
        var urls = new List<LinkUrl>();
        foreach (string text in result.Tokens.Select(t => t.Value))
        {
            if (LinkUrl.TryParse(text, out LinkUrl? url, out string? error))
                urls.Add(url!);
            else
                result.AddError(error!);
        }

        return urls.ToArray();
    }

    private static long? ParseSeed(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (long.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out long seed))
            return seed;
        result.AddError($"--seed {text}: it must be a whole number, 0 or more.");
        return null;
    }

    private static int? ParseTargets(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int count) && count <= MaxTargets)
            return count;
        result.AddError($"{((OptionResult)result.Parent!).Option.Name} {text}: it must be a number from 0 to {MaxTargets}.");
        return null;
    }

    private static byte? ParseSystemId(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (byte.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out byte id) && id != 0)
            return id;
        result.AddError($"--system-id {text}: it must be a number from 1 to 255.");
        return null;
    }
}

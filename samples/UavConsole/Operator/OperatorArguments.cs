using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace UavConsole;

/// <summary>The options of the operator: what to do with a vehicle in flight, at the start and at the end.</summary>
internal static class OperatorArguments
{
    /// <summary>Where the progress of a mission goes when nothing else is asked for.</summary>
    public const string DefaultProgress = "progress.json";

    private static readonly Option<bool> Hold = new("--hold")
    {
        Description = "Takes the command of a vehicle that is flying already at the start, and has it hold its "
            + "position; needs --fly.",
    };

    private static readonly Option<bool> Return = new("--return")
    {
        Description = "Takes the command of a vehicle that is flying already at the start, and has it return and "
            + "land; needs --fly.",
    };

    private static readonly Option<string> Resume = new("--resume")
    {
        Description = "Continues the mission of an earlier flight by its progress file: what is flown and seen is not "
            + "flown again.",
        HelpName = "FILE",
    };

    private static readonly Option<string> Progress = new("--progress")
    {
        Description = "Where the progress of the mission is kept, for --resume. "
            + $"{DefaultProgress} with --fly without it; a file of another flight is kept beside it, under its date.",
        HelpName = "FILE",
    };

    private static readonly Option<bool> AllowPartialSearch = new("--allow-partial-search")
    {
        Description = "Begins a mission that the battery cannot fly to its end: the vehicle returns in time, and "
            + "--resume flies the rest later. As allowPartialSearch of the mission file.",
    };

    private static readonly Option<double?> FixedWing = new("--fixed-wing")
    {
        Description = "Lets --fly command a fixed wing; METRES, 20 to 400, is the radius of its circles. Its pilot takes "
            + "off, gives it over in the air (GUIDED of ArduPilot, AUTO.LOITER of PX4) and lands it. Each leg is one "
            + "DO_REPOSITION, holding is a circle, targets are not revisited. On PX4 a pilot's Hold has no effect and "
            + "cannot be seen: take another mode.",
        HelpName = "METRES",
        CustomParser = ParseRadius,
    };

    private static readonly Option<bool> BellOption = new("--bell")
    {
        Description = "Rings the bell of the terminal at each target that is confirmed, and at a failsafe.",
    };

    private static readonly Option<string> Commanders = new("--commanders")
    {
        Description = "System ids of the ground stations that may command the mission by MAVLink commands to our "
            + "component: ID[,ID] or none. Goes with --fly.",
        HelpName = "IDS",
        DefaultValueFactory = _ => "255",
    };

    private static readonly Option<bool> SignedCommands = new("--signed-commands")
    {
        Description = "Obeys MAVLink commands to our component only where they are signed (--sign-key). Needs "
            + "--fly.",
    };

    private static readonly Option<bool> TargetsAsTraffic = new("--targets-as-traffic")
    {
        Description = "Sends confirmed targets as traffic (ADSB_VEHICLE) too, for ground stations that draw nothing else "
            + "on their map; on links to ground stations only, never towards an autopilot. Needs --fly.",
    };

    private static readonly Option<bool> OffersFence = new("--offer-fence")
    {
        Description = "Offers the autopilot's fence, once others have changed it, as another area: the operator's next "
            + "continue takes it over, smaller by a margin. Needs --fly.",
    };

    private static readonly Option<string> OnStopOption = CreateOnStop();

    /// <summary>All of them.</summary>
    public static IEnumerable<Option> All
        =>
        [
            Hold, Return, Resume, Progress, AllowPartialSearch, FixedWing, OnStopOption, BellOption, Commanders,
            SignedCommands, TargetsAsTraffic, OffersFence,
        ];

    /// <summary>Keys of the section Uav of a configuration file that options stand for.</summary>
    public static IEnumerable<(Option Option, string Key)> Replaced
        =>
        [
            (Resume, "MissionControl:Resume"), (Progress, "MissionControl:ProgressFile"),
            (OnStopOption, "MissionControl:OnStop"), (FixedWing, "MissionControl:FixedWing"),
            (Commanders, "GroundCommands"), (SignedCommands, "GroundCommands"), (OffersFence, "GroundCommands"),
        ];

    public static OperatorChoices Read(ParseResult result, bool flies, ConfigFile? config) => new()
    {
        AtStart = result.GetValue(Hold) ? OperatorCommand.Hold
            : result.GetValue(Return) ? OperatorCommand.Return : null,
        ResumeFile = result.GetValue(Resume) ?? config?.TextOf("MissionControl:Resume"),
        ProgressFile = result.GetValue(Progress) ?? config?.Options.MissionControl.ProgressFile
            ?? (flies ? DefaultProgress : null),
        AllowsPartialSearch = result.GetValue(AllowPartialSearch)
            || config?.Options.MissionControl.AllowsPartialSearch == true,
        LoiterRadiusMetres = result.GetValue(FixedWing),
        HasBell = result.GetValue(BellOption),
        Commanders = flies && TryReadIds(result.GetValue(Commanders)!, out byte[] ids) ? ids : [],
        OnlySigned = result.GetValue(SignedCommands),
        SendsTargetsAsTraffic = result.GetValue(TargetsAsTraffic)
            || config?.Options.Communications.SendsTargetsAsTraffic == true,
        Configured = flies ? config?.Options.GroundCommands : null,
        OffersFence = result.GetValue(OffersFence),
        OnStop = result.GetValue(OnStopOption) is { } onStop
            ? onStop == "return" ? OnStop.Return : OnStop.Hold
            : config?.Options.MissionControl.OnStop ?? OnStop.Hold,
    };

    /// <summary>What makes no sense together.</summary>
    public static IEnumerable<string> FindFaults(ParseResult result, Given given)
    {
        bool flies = given.Flies.Value;
        if (result.GetValue(Hold) && result.GetValue(Return))
            yield return "--hold and --return exclude each other.";
        foreach (string name in Given(result, Hold, Return, FixedWing))
        {
            if (!flies)
                yield return $"{name} commands a real vehicle: it goes with --link URL --mission FILE --fly.";
        }

        if (!TryReadIds(result.GetValue(Commanders)!, out _))
            yield return $"--commanders {result.GetValue(Commanders)}: it must be system ids, 1 to 255, with commas "
                + "between them, or none.";
        foreach (string name in Given(result, Commanders, SignedCommands, TargetsAsTraffic, OffersFence))
        {
            if (!flies)
                yield return $"{name} goes with a mission that is flown: --mission FILE --fly.";
        }

        foreach (string name in Given(result, Resume, Progress, AllowPartialSearch, OnStopOption))
        {
            if (!flies && !given.IsSimulated)
                yield return $"{name} goes with a mission that is flown: --mission FILE --fly.";
        }
    }

    private static IEnumerable<string> Given(ParseResult result, params Option[] options)
        => options.Where(o => result.GetResult(o) is { Implicit: false }).Select(o => o.Name);

    private static bool TryReadIds(string text, out byte[] ids)
    {
        ids = [];
        if (text == "none")
            return true;
        string[] parts = text.Split(',');
        ids = new byte[parts.Length];
        for (int i = 0; i < parts.Length; i++)
        {
            if (!byte.TryParse(parts[i], NumberStyles.None, CultureInfo.InvariantCulture, out ids[i]) || ids[i] == 0)
                return false;
        }

        return true;
    }

    private static double? ParseRadius(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double radius)
            && radius is >= 20 and <= 400)
            return radius;
        result.AddError($"--fixed-wing {text}: it must be the radius of its circles, 20 to 400 m.");
        return null;
    }

    private static Option<string> CreateOnStop()
    {
        var option = new Option<string>("--on-stop")
        {
            Description = "What the vehicle does when the program is stopped while it flies it: hold or return. hold "
                + "without it.",
            HelpName = "WHAT",
        };
        option.AcceptOnlyFromAmong("hold", "return");
        return option;
    }
}

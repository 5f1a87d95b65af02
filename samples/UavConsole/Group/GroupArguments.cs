using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Linq;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>The options of the command line for several vehicles.</summary>
internal static class GroupArguments
{
    // What is of one vehicle.
    private static readonly string[] Alone =
    [
        "--config", "--sign-key", "--web", "--summary", "--export", "--tlog-dir", "--tlog-size", "--keep-pictures",
        "--keep-all-pictures", "--progress", "--resume", "--system-id", "--bell", "--on-stop",
    ];

    // What a vehicle of a group does not do.
    private static readonly string[] NotInAGroup = ["--fixed-wing", "--terrain", "--resume"];

    /// <summary>How many search together.</summary>
    public static Option<int?> Vehicles { get; } = new("--vehicles")
    {
        Description = "How many simulated vehicles search the area together, 1 to "
            + $"{SimulatedGroupOptions.MaxVehicles}. They divide its lanes, each flies 20 m above the one before it "
            + "(--layer-spacing), of three and more the first 5 m below the height of the mission, none above 120 m: "
            + "the bundled mission, 40 m high, has room for 5, of which 3 are low enough for its smallest target. "
            + "Beside the report of the group each has one of its own. It does not go with "
            + string.Join(", ", Alone) + ". 1 without it.",
        HelpName = "N",
        CustomParser = Parse,
    };

    /// <summary>In which height a real vehicle searches together with others.</summary>
    public static Option<int?> Layer { get; } = new("--group-layer")
    {
        Description = "Searches the area together with other vehicles that fly the same --mission, and validates their "
            + $"targets: N layers of 20 m above its height, 0 to {GroupOptions.MaxLayer}, each vehicle another one; "
            + "needs --fly, and a --link to the others (docs/how-to.md).",
        HelpName = "N",
        CustomParser = ParseLayer,
    };

    /// <summary>How far two layers are apart.</summary>
    public static Option<double?> LayerSpacing { get; } = new("--layer-spacing")
    {
        Description = "From one height layer of a group to the next, 19 to 100 m, the same for all; with --vehicles or "
            + "--group-layer: 15 m of separation, and the errors of heights. 20 without it.",
        HelpName = "METRES",
        CustomParser = ParseSpacing,
    };

    /// <summary>What the simulated ground station commands.</summary>
    public static Option<ScriptedCommand[]> Commands { get; } = new("--command")
    {
        Description = "What the ground station of --vehicles commands by radio, and when: " + ScriptedCommand.Form
            + ". May be given again.",
        HelpName = "WHEN:WHO:WHAT",
        CustomParser = ParseCommands,
    };

    public static int Read(ParseResult result) => result.GetValue(Vehicles) ?? 1;

    /// <summary>How a real vehicle searches with others; null where it searches alone.</summary>
    public static GroupOptions? ReadGroup(ParseResult result)
    {
        if (result.GetValue(Layer) is not { } layer)
            return null;
        var options = new GroupOptions { HeightLayer = layer };
        options.LayerSpacingMetres = result.GetValue(LayerSpacing) ?? options.LayerSpacingMetres;
        return options;
    }

    /// <summary>What does not go with several vehicles.</summary>
    public static IEnumerable<string> FindFaults(ParseResult result, Given given)
    {
        if (result.GetValue(Layer) is not null && !given.Flies.Value)
            yield return $"{Layer.Name} needs --link URL, --mission FILE and --fly; the simulation has --vehicles.";
        foreach (string name in NotInAGroup.Where(n => result.GetValue(Layer) is not null && IsGiven(result, n)))
            yield return $"{name} does not go with {Layer.Name}.";
        bool isGroup = Read(result) > 1;
        if (result.GetValue(LayerSpacing) is not null && !isGroup && result.GetValue(Layer) is null)
            yield return $"{LayerSpacing.Name} needs {Vehicles.Name} 2 or more, or {Layer.Name}.";
        if (result.GetValue(Commands) is { Length: > 0 } && !isGroup)
            yield return $"{Commands.Name} needs {Vehicles.Name} 2 or more: it is for the ground station of a "
                + "simulated group.";
        if (result.GetValue(Vehicles) is not null && !given.IsSimulated)
        {
            yield return "--vehicles is for the simulation; of real vehicles each has a UavConsole of its own.";
            yield break;
        }

        if (!isGroup)
            yield break;

        foreach (ScriptedCommand command in (result.GetValue(Commands) ?? []).Where(c => c.Vehicle > Read(result)))
            yield return $"{Commands.Name} {command.Text}: there is no vehicle {command.Vehicle}; {Vehicles.Name} "
                + $"{Read(result)} has the vehicles 1 to {Read(result)}.";
        foreach (string name in Alone.Where(n => IsGiven(result, n)))
            yield return $"{name} is for one vehicle; it does not go with --vehicles.";
    }

    private static bool IsGiven(ParseResult result, string option) => result.Tokens.Any(t => t.Value == option);

    private static int? ParseLayer(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int layer)
            && layer <= GroupOptions.MaxLayer)
            return layer;
        result.AddError($"--group-layer {text}: it must be a number from 0 to {GroupOptions.MaxLayer}.");
        return null;
    }

    private static double? ParseSpacing(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double metres)
            && metres is >= GroupOptions.MinLayerSpacingMetres and <= 100)
            return metres;
        result.AddError($"--layer-spacing {text}: it must be a number of metres from "
            + $"{GroupOptions.MinLayerSpacingMetres} to 100: 15 m of separation, and the errors of heights.");
        return null;
    }

    private static ScriptedCommand[] ParseCommands(ArgumentResult result)
    {
        var commands = new List<ScriptedCommand>();
        foreach (string text in result.Tokens.Select(t => t.Value))
        {
            if (ScriptedCommand.TryParse(text) is { } command)
                commands.Add(command);
            else
                result.AddError($"--command {text}: it must be {ScriptedCommand.Form}.");
        }

        return [.. commands];
    }

    private static int? Parse(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int count)
            && count is >= 1 and <= SimulatedGroupOptions.MaxVehicles)
            return count;
        result.AddError($"--vehicles {text}: it must be a number from 1 to {SimulatedGroupOptions.MaxVehicles}.");
        return null;
    }
}

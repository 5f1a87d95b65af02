using Rabit.Uav.Communications;

namespace UavConsole;

/// <summary>What the command line asked for about the recording of the links.</summary>
internal sealed class RecordingChoices
{
    private const string NameWithoutMission = "flight";

    /// <summary>Whether it was asked for, or for none; null for the default: where a live link is open.</summary>
    public bool? IsWanted { get; init; }

    /// <summary>As the configuration file says; null where it says nothing.</summary>
    public RecordingOptions? Configured { get; init; }

    /// <summary>Where the logs go; null for the current folder.</summary>
    public string? Folder { get; init; }

    /// <summary>How large a file may become; null for the default of the library.</summary>
    public long? MaxFileBytes { get; init; }

    /// <summary>The options of the library.</summary>
    /// <param name="isByDefault">Whether it is wanted where nothing was said.</param>
    /// <param name="mission">The name of the mission that is flown; null for none.</param>
    /// <param name="mustStart">Whether a vehicle that may be in the air waits for a command at the start.</param>
    /// <returns>Null for no recording.</returns>
    public RecordingOptions? ToOptions(bool isByDefault, string? mission, bool mustStart = false)
    {
        if (!(IsWanted ?? (Configured is not null || isByDefault)))
            return null;
        RecordingOptions options = Configured ?? new RecordingOptions();
        string name = mission is null ? NameWithoutMission : RunFiles.StemOf(mission);
        if (options.Name == new RecordingOptions().Name)
            options.Name = name.Length > 0 ? name : NameWithoutMission;
        options.Folder = Folder ?? options.Folder;

        // A full disk must not keep a vehicle that is in the air from its computer, nor a default from a start.
        options.IsRequired = !mustStart && (Folder is not null || Configured?.IsRequired == true);
        options.MaxFileBytes = MaxFileBytes ?? options.MaxFileBytes;
        return options;
    }
}

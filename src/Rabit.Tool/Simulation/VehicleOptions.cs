using Rabit.Links;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Simulation;

namespace Rabit.Tool.Simulation;

/// <summary>What the command line asked for.</summary>
internal sealed class VehicleOptions(
    LinkUrl link, SimulationOptions world, string? missionFile, string? truthFile, string? cameraFolder,
    string? signKeyFile, int groupSize)
{
    public LinkUrl Link { get; } = link;

    /// <summary>Without what the mission says; see <see cref="MissionFile"/>.</summary>
    public SimulationOptions World { get; } = world;

    /// <summary>How many vehicles stand side by side in the world, of which the system id says the one.</summary>
    public int GroupSize { get; } = groupSize;

    /// <summary>A mission whose home and area are those of the world; null for the defaults.</summary>
    public string? MissionFile { get; } = missionFile;

    /// <summary>Where the pictures of its camera go; null for nowhere.</summary>
    public string? CameraFolder { get; } = cameraFolder;

    /// <summary>The file of the key that the link is signed with; null where it is not.</summary>
    public string? SignKeyFile { get; } = signKeyFile;

    /// <summary>Where the truth goes as JSON, at the start and again at the end; null for nowhere.</summary>
    public string? TruthFile { get; } = truthFile;
}

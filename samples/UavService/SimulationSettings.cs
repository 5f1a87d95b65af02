using Microsoft.Extensions.Configuration;

namespace UavService;

/// <summary>The section "Simulation" of the configuration.</summary>
internal sealed class SimulationSettings
{
    public const string Section = "Simulation";
    private const int MaxTargets = 50;

    /// <summary>Whether a simulated vehicle is flown in the place of one behind a link.</summary>
    public bool Enabled { get; set; }

    /// <summary>Of the world.</summary>
    public long Seed { get; set; } = 1;

    /// <summary>How many targets there are.</summary>
    public int Targets { get; set; } = 5;

    /// <exception cref="SettingException">A setting is not known, or its value cannot be.</exception>
    public static SimulationSettings Read(IConfiguration configuration)
    {
        var settings = SettingSection.Read<SimulationSettings>(configuration, Section);
        return settings.Targets is >= 0 and <= MaxTargets
            ? settings
            : throw new SettingException(
                [$"{Section}:{nameof(Targets)} is {settings.Targets}; it must be 0 to {MaxTargets}"]);
    }
}

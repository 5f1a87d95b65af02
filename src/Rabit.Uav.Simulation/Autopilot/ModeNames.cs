using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>The flight modes of the simulated autopilots by name and number.</summary>
internal static class ModeNames
{
    public static bool IsKnown(SimulatedAutopilot autopilot, uint number)
        => autopilot == SimulatedAutopilot.Px4 ? Px4ModeNames.IsFlown(number) : CopterModes.IsKnown(number);

    /// <summary>The number of a mode by its own name, in any case.</summary>
    public static bool TryFind(SimulatedAutopilot autopilot, string name, out uint number)
    {
        if (autopilot == SimulatedAutopilot.Px4)
            return Px4ModeNames.TryFind(name, out number);
        bool isKnown = CopterModes.TryFind(name, out CopterMode mode);
        number = (uint)mode;
        return isKnown;
    }
}

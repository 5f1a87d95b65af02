namespace Rabit.Uav.Simulation;

/// <summary>
/// The pilot's remote control and its receiver: whether it is received, and what the pilot's mode switch says. The
/// sticks are centred.
/// </summary>
internal sealed class RemoteControl
{
    public bool IsReceived { get; set; } = true;

    /// <summary>The flight mode at the position of the switch; null until the pilot has used it.</summary>
    public uint? ModeOfSwitch { get; private set; }

    /// <summary>How often the switch was moved: the same mode may be taken twice.</summary>
    public int SwitchCount { get; private set; }

    /// <summary>The pilot moves the switch to a flight mode.</summary>
    public void SwitchTo(uint mode)
    {
        ModeOfSwitch = mode;
        SwitchCount++;
    }
}

using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Messages;

/// <summary>A parameter of the autopilot as it was reported last. A plain value.</summary>
/// <param name="Name">By the autopilot's own name, for example <c>RTL_ALT</c>.</param>
/// <param name="Value">In the autopilot's own unit; NaN where it is not known.</param>
/// <param name="Type">What the autopilot keeps it as; meaningful only where the value is known.</param>
public readonly record struct AutopilotParameter(string Name, double Value, MavParamType Type)
{
    /// <summary>Whether the autopilot has reported it.</summary>
    public bool IsKnown => !double.IsNaN(Value);
}

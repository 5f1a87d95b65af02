using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>One parameter: its name, the type that it is sent with, and its value.</summary>
internal sealed class Parameter(string name, MavParamType type, float value)
{
    public string Name { get; } = name;

    public MavParamType Type { get; } = type;

    /// <summary>What it is before anything has set it.</summary>
    public float Default { get; } = value;

    /// <summary>As it is sent: a whole number is sent as a float of the same value (PARAM_ENCODE_C_CAST).</summary>
    public float Value { get; private set; } = value;

    /// <summary>A type of whole numbers keeps the whole part.</summary>
    public void Set(float newValue)
        => Value = Type == MavParamType.Real32 ? newValue : (float)System.Math.Truncate(newValue);
}

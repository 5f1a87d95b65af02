using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>Who the autopilot is.</summary>
internal sealed class AutopilotAddress(ParameterStore parameters)
{
    public const byte ComponentId = (byte)MavComponent.Autopilot1;

    /// <summary>As SYSID_THISMAV has it.</summary>
    public byte SystemId => (byte)NedMath.Limited(parameters.SystemId.Value, 1, byte.MaxValue);
}

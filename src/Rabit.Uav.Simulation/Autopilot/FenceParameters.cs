using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>ArduCopter's parameters of its fence, with the defaults of ArduPilot.</summary>
internal sealed class FenceParameters
{
    /// <param name="add">Takes a name, a type and a default into the store.</param>
    public FenceParameters(Func<string, MavParamType, float, Parameter> add)
    {
        Enable = add("FENCE_ENABLE", MavParamType.Int8, 0);
        Type = add("FENCE_TYPE", MavParamType.Int8, 7);
        Action = add("FENCE_ACTION", MavParamType.Int8, 1);
        MaxHeight = add("FENCE_ALT_MAX", MavParamType.Real32, 100);
        Radius = add("FENCE_RADIUS", MavParamType.Real32, 300);
        Margin = add("FENCE_MARGIN", MavParamType.Real32, 2);
        Total = add("FENCE_TOTAL", MavParamType.Int8, 0);
    }

    public Parameter Enable { get; }

    /// <summary>Bits: 1 height, 2 circle around home, 4 polygons and circles that were uploaded.</summary>
    public Parameter Type { get; }

    /// <summary>0: report only, 1: return, 2: land, 4: brake.</summary>
    public Parameter Action { get; }

    /// <summary>Metres above home.</summary>
    public Parameter MaxHeight { get; }

    /// <summary>Metres around home.</summary>
    public Parameter Radius { get; }

    /// <summary>Metres inside the fence; the autopilot's own targets keep it, a breach does not depend on it.</summary>
    public Parameter Margin { get; }

    /// <summary>How many items were uploaded; set by the fence itself.</summary>
    public Parameter Total { get; }
}

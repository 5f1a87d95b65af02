using System;

namespace Rabit.Uav.Messages;

/// <summary>
/// What the firmware of a Raspberry Pi reports: the bits of <c>vcgencmd get_throttled</c>. The first four are now, the
/// last four at any time since its start.
/// </summary>
[Flags]
public enum ComputerThrottling
{
    /// <summary>Nothing.</summary>
    None = 0,

    /// <summary>The supply is below 4.63 V.</summary>
    UnderVoltage = 1,

    /// <summary>The clock of the processor is capped.</summary>
    FrequencyCapped = 2,

    /// <summary>The processor is throttled.</summary>
    Throttled = 4,

    /// <summary>The soft limit of the temperature is reached.</summary>
    SoftTemperatureLimit = 8,

    /// <summary>What is so now, and not only at some time since the start.</summary>
    Now = UnderVoltage | FrequencyCapped | Throttled | SoftTemperatureLimit,

    /// <summary>The supply was below 4.63 V.</summary>
    UnderVoltageOccurred = 65536,

    /// <summary>The clock of the processor was capped.</summary>
    FrequencyCappedOccurred = 131072,

    /// <summary>The processor was throttled.</summary>
    ThrottledOccurred = 262144,

    /// <summary>The soft limit of the temperature was reached.</summary>
    SoftTemperatureLimitOccurred = 524288,
}

using System;
using Rabit.Mavlink;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The autopilot as the vehicle around it sees it: it is given what its sensors measure, says how to move, and takes
/// and sends messages. The vehicle's thread only.
/// </summary>
internal interface IVehicleAutopilot
{
    byte SystemId { get; }

    /// <summary>Of the battery that it is set up for.</summary>
    double BatteryCapacityAmpereHours { get; }

    bool IsArmed { get; }

    /// <summary>Flight mode, by its own number.</summary>
    uint CustomMode { get; }

    /// <summary>Flight mode, by its own name.</summary>
    string ModeName { get; }

    /// <summary>Whether it knows where it is.</summary>
    bool HasPosition { get; }

    /// <summary>Whether it was commanded to reboot and may do so.</summary>
    bool WantsReboot { get; }

    /// <summary>Sets a parameter; the options have been checked for its name.</summary>
    void SetParameter(string name, float value);

    /// <summary>The autopilot after a reboot: it keeps what is stored and nothing else.</summary>
    /// <param name="time">Of the reboot, by the clock of the run.</param>
    /// <param name="bootTime">How long it neither takes nor sends anything.</param>
    /// <param name="staysArmed">Whether it is armed as before, as after a reset by its watchdog.</param>
    IVehicleAutopilot Restarted(TimeSpan time, TimeSpan bootTime, bool staysArmed);

    /// <summary>Changes the mode, as by the switch of the remote control; false where that is not possible.</summary>
    bool TrySetMode(uint customMode);

    /// <summary>How to move in the next step.</summary>
    MotionCommand Step(in VehicleSenses senses);

    /// <summary>The state that the following messages report.</summary>
    void Observe(in AutopilotState state);

    /// <summary>Takes a frame that has come over the link.</summary>
    /// <param name="frame">One that a reader has checked.</param>
    /// <param name="bootNanoseconds">When it came, by the autopilot's clock.</param>
    /// <param name="link">The number of the link that it came over, from 0; see <see cref="SecondLink"/>.</param>
    void Handle(in MavlinkFrame frame, long bootNanoseconds, int link);

    /// <summary>Sends what is due, once in a step.</summary>
    /// <param name="time">By the clock of the run.</param>
    /// <param name="bootNanoseconds">The same by the autopilot's clock.</param>
    void SendWhatIsDue(TimeSpan time, long bootNanoseconds);
}

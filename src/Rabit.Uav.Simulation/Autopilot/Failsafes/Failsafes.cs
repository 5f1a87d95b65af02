using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What the autopilot watches by itself. By default most of it is reported only, or off, as in ArduCopter.
/// </summary>
internal sealed class Failsafes
{
    private readonly FlightController _controller;

    public Failsafes(ParameterStore parameters, FlightController controller, Action<MavSeverity, string> say)
    {
        _controller = controller;
        var response = new FailsafeResponse(controller, parameters, say);
        Battery = new BatteryFailsafe(parameters, response, say);
        GroundStation = new GroundStationFailsafe(parameters, response, say);
        Radio = new RadioFailsafe(parameters, response, say);
        Estimator = new EstimatorFailsafe(controller, parameters, say);
        Fence = new FenceFailsafe(controller, parameters, say);
    }

    public BatteryFailsafe Battery { get; }

    public GroundStationFailsafe GroundStation { get; }

    public RadioFailsafe Radio { get; }

    public EstimatorFailsafe Estimator { get; }

    public FenceFailsafe Fence { get; }

    /// <summary>Whether the heartbeat reports MAV_STATE_CRITICAL. A breach of the fence does not count.</summary>
    public bool IsAnyOn => Battery.IsOn || GroundStation.IsOn || Radio.IsOn || Estimator.IsOn;

    /// <summary>One step.</summary>
    /// <param name="senses">What is measured.</param>
    /// <param name="isRadioReceived">Of the remote control, or of a ground station instead of it.</param>
    /// <param name="stepSeconds">The length of the step.</param>
    public void Step(in VehicleSenses senses, bool isRadioReceived, double stepSeconds)
    {
        Battery.Volts = senses.BatteryVolts;
        Battery.ConsumedAmpereHours = senses.ConsumedAmpereHours;
        if (_controller.IsArmed)
            Battery.Step(stepSeconds);
        GroundStation.Step(senses.Time);
        Radio.Step(isRadioReceived, senses.Time);
        Estimator.Step(senses, stepSeconds);
        Fence.Step();
    }
}

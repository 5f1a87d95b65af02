using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The vehicle and what it carries: the autopilot, its position, the battery, the camera.
public sealed partial class HealthManager
{
    private readonly HealthRuleSet<VehicleFacts> _vehicleRules = new(HealthRules.OfVehicle);
    private readonly HealthRuleSet<PositionFacts> _positionRules = new(HealthRules.OfPosition);
    private readonly HealthRuleSet<VehicleFacts> _batteryRules = new(HealthRules.OfBattery);
    private readonly HealthRuleSet<BatteryFacts> _batteryStateRules = new(HealthRules.OfBatteryState);
    private readonly HealthRuleSet<VehicleFacts> _energyRules = new(HealthRules.OfEnergy);
    private readonly HealthRuleSet<CameraFacts> _cameraRules = new(HealthRules.OfCamera);
    private readonly HealthRuleSet<TargetFacts> _targetRules = new(HealthRules.OfTargets);
    private readonly WindGusts _gusts = new();
    private readonly PositionWatch _position = new();
    private readonly BatteryCellWatch _battery = new();
    private readonly MessageSubscriber<NavigationStatus> _navigation;

    private void EvaluateVehicle(TimeSpan now, bool isReplayOver)
    {
        _vehicle.Fetch();
        _autopilot.Fetch();
        _navigation.Fetch();
        _mission.Fetch();
        EnergyStatus energy = _mission.Age <= MaxEnergyAge ? _mission.Value.Energy : default;
        ref readonly VehicleState state = ref _vehicle.Value;
        var vehicle = new VehicleFacts(
            state, _autopilot.Value.RateRequests, now, isReplayOver, _gusts.Update(state, now), energy);
        _vehicleRules.Evaluate(vehicle, subject: null, _options, now, _findings);
        PositionFacts position = _position.Update(state, _navigation.Value, now, _options);
        _positionRules.Evaluate(position, subject: null, _options, now, _findings);
        _batteryRules.Evaluate(vehicle, subject: null, _options, now, _findings);
        BatteryFacts battery = _battery.Update(state, now, _options, vehicle.IsEnergyKnown);
        _batteryStateRules.Evaluate(battery, subject: null, _options, now, _findings);
        _energyRules.Evaluate(vehicle, subject: null, _options, now, _findings);
        _cameraRules.Evaluate(_camera.Update(now, _isImagingStuck, _options), subject: null, _options, now, _findings);
        _targetRules.Evaluate(
            new TargetFacts(_mission.Value, _autopilot.Value), subject: null, _options, now, _findings);
    }
}

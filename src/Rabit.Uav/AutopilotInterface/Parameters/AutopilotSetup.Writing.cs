using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;

namespace Rabit.Uav.AutopilotInterface;

// What is written, in which order, and written back.
internal sealed partial class AutopilotSetup
{
    // Bit 2 of FENCE_TYPE: polygons (ArduPilot documentation, "Geo-Fencing").
    private const int PolygonFence = 1 << 2;
    private const int MinCorners = 3;

    // With a fence of ours: what makes ArduPilot keep to it. PX4 does so by GF_ACTION, a line of the checklist.
    private (string Name, Func<double, double> Change)[] FenceParameters(MavAutopilot autopilot)
        => _options.Fence is not null && autopilot == MavAutopilot.Ardupilotmega
            ? [("FENCE_TYPE", v => (int)v | PolygonFence), ("FENCE_ENABLE", _ => 1)]
            : [];

    /// <returns>Whether something was queued.</returns>
    private bool TryQueueWriting(PreflightFacts facts, bool isStopping)
    {
        if (_store is null)
            return false;
        bool isOver = _hasFlown || isStopping || !_options.Writes;
        if (isOver)
            return TryQueueRestoring();
        if (_hasWritten || _state == AutopilotSetupState.Failed
            || (_options.Fence is not null && facts.Vehicle.PositionTime is null))
            return false;
        QueueWriting(facts);
        return true;
    }

    private void Load(byte systemId)
    {
        _hasLoaded = true;
        string? fault = _store!.Load(out _originals);
        if (fault is null && _originals is { } found && found.SystemId != systemId)
        {
            fault = string.Format(
                CultureInfo.InvariantCulture, "{0} has the values of vehicle {1}, not those of {2}",
                _options.OriginalsFile, found.SystemId, systemId);
            _originals = null;
        }

        if (fault is null)
            return;
        _log(fault);
        Set(AutopilotSetupState.Failed, fault);
    }

    private void QueueWriting(PreflightFacts facts)
    {
        facts.Parameters = new AutopilotParameters { IsComplete = true, All = _known.ToArray() };
        _hasWritten = true;
        _faults.Clear();
        List<(string Name, double Value)> failsafes = _options.SetsFailsafes ? FindChanges(facts) : [];
        List<(string Name, double Value)> ofFence = FenceParameters(facts.Vehicle.Autopilot)
            .Select(p => (p.Name, Now: _known.Find(p.Name), p.Change))
            .Where(p => p.Now.IsKnown && !p.Change(p.Now.Value).Equals(p.Now.Value))
            .Select(p => (p.Name, p.Change(p.Now.Value))).ToList();
        IReadOnlyList<FenceItem>? own = null;
        if (_options.Fence is not null)
            _steps.Enqueue(new FenceReadStep(_fence, items => own = items));
        byte systemId = facts.Vehicle.SystemId;
        IReadOnlyList<FenceItem>? ours = _options.Fence is { } make
            ? FencePolygon.ToItems(make(GroundOf(facts.Vehicle)))
            : null;
        if (ours is { Count: >= MinCorners })
        {
            ours = ours.Concat(_options.KeepOuts.SelectMany(
                k => FencePolygon.ToItems(k, MavCmd.NavFencePolygonVertexExclusion))).ToArray();
        }

        if (ours is { Count: < MinCorners })
            _faults.Add("the mission cannot be flown from here: there is no fence to upload");
        _steps.Enqueue(new LocalStep(() =>
        {
            // Nothing is written unless what is replaced is known and kept.
            if (_faults.Count == 0 && Keep(systemId, failsafes.Concat(ofFence), own) is { } fault)
                _faults.Add(fault);
            if (_faults.Count > 0)
                Set(AutopilotSetupState.Failed, string.Join("; ", _faults));
            else
                QueueWrites(failsafes, ours, ofFence);
            return null;
        }));
    }

    private static List<(string Name, double Value)> FindChanges(PreflightFacts facts)
        => PreflightRules.ParametersOf(
            facts.Vehicle.Autopilot, FixedWings.IsFixedWing(facts.Vehicle.VehicleType)).Select(r => r.FindChange(facts))
            .OfType<(string Name, double Value)>().ToList();

    // Home is where it stands: its altitude is that of the ground.
    private static GeodeticPosition GroundOf(in VehicleState vehicle) => GeodeticPosition.FromRadians(
        vehicle.Position.Latitude.Radians, vehicle.Position.Longitude.Radians,
        vehicle.Position.AltitudeAmslMetres - vehicle.HeightAboveHomeMetres);

    private string? Keep(
        byte systemId, IEnumerable<(string Name, double Value)> changes, IReadOnlyList<FenceItem>? fence)
    {
        AutopilotParameter[] own = changes.Select(c => _known.Find(c.Name)).ToArray();
        if (own.Length == 0 && fence is null && _originals is null)
            return null;
        Originals originals = (_originals ?? new Originals(systemId, [], null)).With(own, fence);
        string? fault = _store!.Save(originals);
        if (fault is not null)
            return "nothing is written to the autopilot: " + fault;
        _originals = originals;
        return null;
    }

    private void QueueWrites(
        List<(string Name, double Value)> failsafes, IReadOnlyList<FenceItem>? fence,
        List<(string Name, double Value)> ofFence)
    {
        QueueSets(failsafes);
        if (fence is not null)
            _steps.Enqueue(new FenceWriteStep(_fence, fence));
        QueueSets(ofFence);
        int written = failsafes.Count + ofFence.Count;
        _steps.Enqueue(new LocalStep(() =>
        {
            string text = string.Format(
                CultureInfo.InvariantCulture, "{0} parameters set{1}", written,
                fence is null ? string.Empty : ", fence of " + fence.Count + " corners uploaded");
            if (_faults.Count > 0)
                Set(AutopilotSetupState.Failed, string.Join("; ", _faults));
            else
                Set(AutopilotSetupState.Done, text);
            _log("before the flight: " + _text);
            return null;
        }));
    }

    private void QueueSets(IEnumerable<(string Name, double Value)> changes)
    {
        foreach ((string name, double value) in changes)
        {
            AutopilotParameter own = _known.Find(name);
            _log(string.Format(CultureInfo.InvariantCulture, "{0} is set from {1} to {2}", name, own.Value, value));
            _steps.Enqueue(new WriteStep(_parameters, name, own.Type, value));
        }
    }

    private bool TryQueueRestoring()
    {
        if (_originals is not { } originals || _state is AutopilotSetupState.Restored or AutopilotSetupState.Restoring)
            return false;
        if (_state == AutopilotSetupState.Failed && _hasRestored)
            return false;
        _hasRestored = true;
        _faults.Clear();
        Set(AutopilotSetupState.Restoring, "the autopilot's own values are being written back");
        foreach (AutopilotParameter parameter in originals.Parameters)
            _steps.Enqueue(new WriteStep(_parameters, parameter.Name, parameter.Type, parameter.Value));
        if (originals.Fence is { } fence)
            _steps.Enqueue(new FenceWriteStep(_fence, fence));
        _steps.Enqueue(new LocalStep(CompleteRestoring));
        return true;
    }

    // The file stays where something could not be written back: the next start tries again.
    private string? CompleteRestoring()
    {
        if (_faults.Count == 0 && _store!.Delete() is { } fault)
            _faults.Add(fault);
        if (_faults.Count > 0)
        {
            Set(AutopilotSetupState.Failed, "not written back: " + string.Join("; ", _faults));
        }
        else
        {
            _originals = null;
            Set(AutopilotSetupState.Restored, "the autopilot has its own values again");
        }

        _log(_text!);
        return null;
    }
}

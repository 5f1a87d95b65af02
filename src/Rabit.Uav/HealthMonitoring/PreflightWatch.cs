using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// Evaluates the pre-flight checklist once a second until the motors run; from then on the last report stands.
/// </summary>
internal sealed class PreflightWatch(
    PreflightOptions options, MessageSubscriber<AutopilotParameters> parameters,
    MessageSubscriber<NavigationStatus> navigation, MessageSubscriber<ImagingStatus> imaging,
    IReadOnlyList<MessageSubscriber<LinkStatus>> links, MessagePublisher<PreflightReport> publisher, Action<string> log)
{
    private static readonly TimeSpan EvaluationPeriod = TimeSpan.FromSeconds(1);

    private readonly PreflightFacts _facts = new(options);
    private TimeSpan? _lastEvaluation;

    public void Update(
        TimeSpan now, in VehicleState vehicle, in OwnAddress own, in ComputerStatus computer, MissionPhase phase)
    {
        bool isBeforeFlight = phase is MissionPhase.NoMission or MissionPhase.WaitingForVehicle or MissionPhase.Arming;
        if (vehicle.IsArmed || !isBeforeFlight || now - _lastEvaluation < EvaluationPeriod)
            return;
        _lastEvaluation = now;
        _facts.Computer = computer;
        FetchFacts(now, vehicle, own);
        PreflightReport report = PreflightChecklist.Evaluate(_facts);
        PreflightReport posted = publisher.Value;
        if (report.IsComplete == posted.IsComplete && report.Lines.SequenceEqual(posted.Lines))
            return;
        LogChanges(posted, report);
        publisher.Value = report;
        publisher.Post();
    }

    private void FetchFacts(TimeSpan now, in VehicleState vehicle, in OwnAddress own)
    {
        _facts.Now = now;
        _facts.Vehicle = vehicle;
        _facts.Own = own;
        if (parameters.Fetch())
            _facts.Parameters = parameters.Value;
        navigation.Fetch();
        _facts.Navigation = navigation.Value;
        imaging.Fetch();
        _facts.Imaging = imaging.Value;
        (_facts.FramesIn, _facts.FramesMissing) = (0, 0);
        foreach (MessageSubscriber<LinkStatus> link in links)
        {
            link.Fetch();
            _facts.FramesIn += link.Value.FramesIn;
            _facts.FramesMissing += link.Value.FramesMissing;
        }
    }

    // A figure that changes all the time is no news, nor is what passes from the first; the end of a failure is.
    private void LogChanges(PreflightReport before, PreflightReport report)
    {
        if (!report.IsComplete)
            return;
        Dictionary<string, PreflightResult> results = before.IsComplete
            ? before.Lines.ToDictionary(l => l.Name, l => l.Result, StringComparer.Ordinal)
            : new Dictionary<string, PreflightResult>(StringComparer.Ordinal);
        foreach (PreflightLine line in report.Lines)
        {
            PreflightResult last = results.TryGetValue(line.Name, out PreflightResult known)
                ? known
                : PreflightResult.Pass;
            bool matters = line.Result is PreflightResult.Fail or PreflightResult.Warn || last == PreflightResult.Fail;
            if (line.Result != last && matters)
                log("pre-flight: " + line);
        }

        if (!before.IsComplete && report.WhenComputerFails.Length > 0)
            log("pre-flight: if this computer fails in flight: " + report.WhenComputerFails);
    }
}

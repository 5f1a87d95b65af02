using System;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>Rings at each target that is newly confirmed, and when a failsafe acts.</summary>
/// <param name="ring">Rings once.</param>
internal sealed class Bell(Action ring)
{
    private int _confirmed;
    private HealthAdvice _advice;
    private string? _aborted;
    private string? _takenOver;

    /// <summary>At each refresh of the view.</summary>
    public void Update(in MissionStatus mission, HealthAdvice advice)
    {
        bool isFailsafe = (advice > _advice) || (mission.Aborted is not null && mission.Aborted != _aborted)
            || (mission.TakenOver is not null && mission.TakenOver != _takenOver);
        bool isTarget = mission.TracksConfirmed > _confirmed;
        (_confirmed, _advice) = (Math.Max(_confirmed, mission.TracksConfirmed), advice);
        (_aborted, _takenOver) = (mission.Aborted, mission.TakenOver);
        if (isFailsafe || isTarget)
            ring();
    }
}

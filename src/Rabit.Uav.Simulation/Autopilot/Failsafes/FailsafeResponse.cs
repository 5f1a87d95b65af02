using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What the autopilot does and says when a failsafe sets in: on the ground it disarms, in the air it does what the
/// parameter says unless FS_OPTIONS lets it go on (Copter's events.cpp).
/// </summary>
internal sealed class FailsafeResponse(
    FlightController controller, ParameterStore parameters, Action<MavSeverity, string> say)
{
    // FS_OPTIONS.
    private const int GoesOnInGuidedWithoutRadio = 1 << 2;
    private const int GoesOnLanding = 1 << 3;
    private const int GoesOnWithPilotWithoutGroundStation = 1 << 4;

    public void Respond(FailsafeCause cause, FailsafeAction action)
    {
        string name = cause switch
        {
            FailsafeCause.Radio => "Radio",
            FailsafeCause.GroundStation => "GCS",
            _ => "Battery",
        };
        if (!controller.IsArmed)
        {
            say(MavSeverity.Warning, name + " Failsafe");
            return;
        }

        if (controller.Situation.IsLanded)
        {
            controller.TryDisarm(isForced: false);
            say(MavSeverity.Warning, name + " Failsafe - Disarming");
            return;
        }

        string? goesOn = WhatGoesOn(cause, ref action);
        say(MavSeverity.Warning, goesOn is null ? name + " Failsafe" : $"{name} Failsafe - {goesOn}");
        Act(action);
    }

    private string? WhatGoesOn(FailsafeCause cause, ref FailsafeAction action)
    {
        int options = (int)parameters.FailsafeOptions.Value;
        if (controller.IsLanding && (options & GoesOnLanding) != 0 && action != FailsafeAction.None)
        {
            action = FailsafeAction.Land;
            return "Continuing Landing";
        }

        bool isGuided = cause == FailsafeCause.Radio && controller.IsGuided
            && (options & GoesOnInGuidedWithoutRadio) != 0;
        bool hasPilot = cause == FailsafeCause.GroundStation && CopterModes.IsFlownByPilot(controller.Mode)
            && (options & GoesOnWithPilotWithoutGroundStation) != 0;
        if (!isGuided && !hasPilot)
            return null;
        action = FailsafeAction.None;
        return isGuided ? "Continuing Guided Mode" : "Continuing Pilot Control";
    }

    private void Act(FailsafeAction action)
    {
        switch (action)
        {
            case FailsafeAction.Land or FailsafeAction.SmartReturnOrLand:
                controller.LandAfterPause();
                break;
            case FailsafeAction.Return or FailsafeAction.SmartReturnOrReturn or FailsafeAction.LandSequenceOrReturn:
                TryOrLand(CopterMode.Rtl);
                break;
            case FailsafeAction.BrakeOrLand:
                TryOrLand(CopterMode.Brake);
                break;
            case FailsafeAction.Terminate:
                controller.TryDisarm(isForced: true);
                break;
        }
    }

    private void TryOrLand(CopterMode mode)
    {
        if (!controller.TrySetMode((uint)mode))
            controller.LandAfterPause();
    }
}

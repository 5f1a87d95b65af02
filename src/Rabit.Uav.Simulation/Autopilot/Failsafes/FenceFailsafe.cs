using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// FENCE_ENABLE and what belongs to it. A breach is reported, acted upon as FENCE_ACTION says, and cleared when the
/// vehicle is back inside; a change of the mode while it lasts gives ten seconds to fly back (AC_Fence).
/// </summary>
internal sealed class FenceFailsafe(
    FlightController controller, ParameterStore parameters, Action<MavSeverity, string> say)
{
    // AC_FENCE_GIVE_UP_DISTANCE: further outside it only lands.
    private const double GiveUpMetres = 100;
    private static readonly TimeSpan RecoveryTime = TimeSpan.FromSeconds(10);

    private TimeSpan? _recoverySince;

    /// <summary>The fence that was uploaded; never null.</summary>
    public FenceShapes Shapes { get; set; } = FenceShapes.None;

    public bool IsEnabled => parameters.Fence.Enable.Value > 0;

    public FenceKinds Breached { get; private set; }

    public int BreachCount { get; private set; }

    /// <summary>Of the last one.</summary>
    public TimeSpan BreachTime { get; private set; }

    /// <summary>Called when a breach begins: FENCE_STATUS is sent at once.</summary>
    public Action? BreachBegan { get; set; }

    public void Step()
    {
        if (!controller.IsArmed || !controller.HasOrigin)
            return;
        FlightSituation situation = controller.Situation;
        FenceKinds outside = IsEnabled ? Outside(situation.Position) : FenceKinds.None;
        if (Breached != FenceKinds.None && outside == FenceKinds.None)
        {
            Breached = FenceKinds.None;
            _recoverySince = null;
            say(MavSeverity.Notice, "Fence breach cleared");
        }

        bool isRecovering = _recoverySince is { } since && situation.Time - since < RecoveryTime;
        FenceKinds more = outside & ~Breached;
        if (more != FenceKinds.None && !isRecovering)
            Begin(more);
    }

    /// <summary>The flight mode has changed, by whatever; the pilot may be flying back.</summary>
    public void ReportModeChange()
    {
        if (Breached == FenceKinds.None || parameters.Fence.Action.Value <= 0)
            return;
        _recoverySince = controller.Situation.Time;
        say(MavSeverity.Info, "Manual recovery started");
    }

    /// <summary>Whether a target is inside; without a fence every one is.</summary>
    public bool Accepts(NedVector place) => !IsEnabled || !controller.HasOrigin || Outside(place) == FenceKinds.None;

    /// <summary>What an arming check says; null where nothing speaks against it.</summary>
    public string? FindReasonNotToArm()
    {
        if (!IsEnabled || !controller.HasOrigin)
            return null;
        FenceKinds outside = Outside(controller.Situation.Position);
        return outside == FenceKinds.None ? null : $"Vehicle breaching {NameOf(outside)} fence";
    }

    private void Begin(FenceKinds more)
    {
        Breached |= more;
        BreachCount++;
        BreachTime = controller.Situation.Time;
        say(MavSeverity.Notice, NameOf(more) + " fence breached");
        BreachBegan?.Invoke();
        int action = (int)parameters.Fence.Action.Value;
        if (action <= 0)
            return;
        if (controller.Situation.IsLanded)
            controller.TryDisarm(isForced: false);
        else if (Shapes.MetresOutside(controller.Situation.Position) > GiveUpMetres)
            controller.TrySetMode((uint)CopterMode.Land);
        else
            Act(action);
    }

    private void Act(int action)
    {
        CopterMode mode = action switch
        {
            2 or 5 => CopterMode.Land,
            4 => CopterMode.Brake,
            _ => CopterMode.Rtl,
        };
        if (!controller.TrySetMode((uint)mode))
            controller.TrySetMode((uint)CopterMode.Land);
    }

    private FenceKinds Outside(NedVector place)
    {
        FenceParameters fence = parameters.Fence;
        NedVector fromHome = place.Minus(controller.Situation.Home);
        var kinds = (FenceKinds)(int)fence.Type.Value;
        FenceKinds outside = FenceKinds.None;
        if (-fromHome.Down > fence.MaxHeight.Value)
            outside |= FenceKinds.MaxHeight;
        if (fromHome.HorizontalLength() > fence.Radius.Value)
            outside |= FenceKinds.Circle;
        if (Shapes.MetresOutside(place) > 0)
            outside |= FenceKinds.Polygon;
        return outside & kinds;
    }

    private static string NameOf(FenceKinds kinds)
    {
        var names = new List<string>();
        if ((kinds & FenceKinds.MaxHeight) != 0)
            names.Add("Max Alt");
        if ((kinds & FenceKinds.Circle) != 0)
            names.Add("Circle");
        if ((kinds & FenceKinds.Polygon) != 0)
            names.Add("Polygon");
        return string.Join(" and ", names);
    }
}

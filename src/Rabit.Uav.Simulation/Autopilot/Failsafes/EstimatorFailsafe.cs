using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// FS_EKF_ACTION: the estimator's variances are above FS_EKF_THRESH for a second, some time after the GPS is lost. Then
/// the autopilot takes no mode that needs a position until the estimate is good again. Times and flags are those of
/// ap-gps-ekf-failsafe.
/// </summary>
internal sealed class EstimatorFailsafe(
    FlightController controller, ParameterStore parameters, Action<MavSeverity, string> say)
{
    // After the GPS is lost: until the variances are too large, and until it no longer counts on a position at all.
    private const double VarianceAfter = 7.1;
    private const double StopsAidingAfter = 15.2;

    // How long the variances must be too large, and good again.
    private const double FailsAfter = 1;
    private const double GlitchAfter = 1.4;

    // With a position, with variances that are too large, and without a position, as recorded.
    private const EkfStatusFlags GoodFlags = (EkfStatusFlags)0x033F;
    private const EkfStatusFlags BadFlags = (EkfStatusFlags)0x0025;
    private const EkfStatusFlags NoPositionFlags = (EkfStatusFlags)0x00A7;

    private double _lossSeconds;
    private double _badSeconds;
    private double _goodSeconds;
    private double _glitchSeconds;
    private bool _isAiding = true;
    private bool _hasActed;

    public bool IsOn { get; private set; }

    public bool IsGlitching { get; private set; }

    /// <summary>Of EKF_STATUS_REPORT.</summary>
    /// <param name="hasOrigin">Whether it has known where it is.</param>
    public EkfStatusFlags FlagsOf(bool hasOrigin)
    {
        if (!hasOrigin || !_isAiding)
            return NoPositionFlags;
        return (_badSeconds > 0 ? BadFlags : GoodFlags) | (IsGlitching ? EkfStatusFlags.GpsGlitching : 0);
    }

    public void Step(in VehicleSenses senses, double stepSeconds)
    {
        _lossSeconds = senses.HasGps || !controller.HasOrigin ? 0 : _lossSeconds + stepSeconds;
        bool isBad = senses.IsEstimatorBad || _lossSeconds > VarianceAfter;
        _badSeconds = isBad ? _badSeconds + stepSeconds : 0;
        _goodSeconds = isBad ? 0 : _goodSeconds + stepSeconds;
        ReportGlitch(senses.IsGpsGlitching, isBad, stepSeconds);
        ReportAiding();
        if (controller.IsArmed && parameters.EstimatorThreshold.Value > 0 && !IsOn && _badSeconds > FailsAfter)
            Begin();
        else if (IsOn && _goodSeconds > FailsAfter)
            End();
    }

    private void Begin()
    {
        IsOn = true;
        say(MavSeverity.Critical, "EKF variance");
        var action = (int)parameters.EstimatorFailsafe.Value;
        bool actsAlways = action == 3;
        if (action == 0 || (!actsAlways && !CopterModes.NeedsPosition(controller.Mode)))
            return;
        if (action != 2 || !controller.TrySetMode((uint)CopterMode.AltHold))
            controller.LandAfterPause();
        _hasActed = true;
        say(MavSeverity.Critical, $"EKF Failsafe: changed to {CopterModes.NameOf(controller.Mode)} Mode");
    }

    private void End()
    {
        IsOn = false;
        if (_hasActed)
            say(MavSeverity.Critical, "EKF Failsafe Cleared");
        _hasActed = false;
    }

    private void ReportGlitch(bool isGlitching, bool isBad, double stepSeconds)
    {
        _glitchSeconds = isGlitching ? _glitchSeconds + stepSeconds : 0;
        bool isOn = _glitchSeconds > GlitchAfter || (isBad && _isAiding);
        if (isOn != IsGlitching)
            say(MavSeverity.Critical, isOn ? "GPS Glitch or Compass error" : "Glitch cleared");
        IsGlitching = isOn;
    }

    private void ReportAiding()
    {
        bool isAiding = _lossSeconds < StopsAidingAfter;
        if (_isAiding && !isAiding)
        {
            say(MavSeverity.Warning, "EKF3 IMU1 stopped aiding");
            say(MavSeverity.Warning, "EKF3 IMU0 stopped aiding");
        }

        _isAiding = isAiding;
    }
}

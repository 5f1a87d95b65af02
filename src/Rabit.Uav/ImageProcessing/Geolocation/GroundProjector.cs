using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// Computes where on the ground the pixels of a camera are (geolocation), with their covariance: lens distortion,
/// mount, lever arms, and ground that is flat and level, or a terrain grid. It holds what stays the same;
/// <see cref="At"/> adds one picture's pose and gimbal. Fixed memory; for one thread.
/// </summary>
internal sealed class GroundProjector
{
    private readonly ErrorBudget _budget;
    private readonly double[] _random;
    private readonly double[] _systematic;
    private readonly double[] _extrapolated = new double[GroundJacobian.Inputs];
    private readonly double[] _ofDetection = new double[GroundJacobian.Inputs];

    public GroundProjector(
        CameraModel camera, CameraMount mount, ErrorBudget budget, Angle minDepression, TerrainGrid? terrain = null)
    {
        Camera = camera;
        Mount = mount;
        MinDepression = minDepression;
        Terrain = terrain;
        Jacobian = new GroundJacobian(camera, mount);
        BearingJacobian = new BearingJacobian(Jacobian);
        _budget = budget;
        _random = Random(budget);
        _systematic = Systematic(budget, camera);
    }

    public CameraModel Camera { get; }

    public CameraMount Mount { get; }

    /// <summary>A ray must point further below the horizon than that.</summary>
    public Angle MinDepression { get; }

    /// <summary>Null where the ground is flat.</summary>
    public TerrainGrid? Terrain { get; }

    /// <summary>Scratch memory of the covariances of a <see cref="GroundProjection"/>.</summary>
    public GroundJacobian Jacobian { get; }

    /// <summary>The same for the bearing of what a picture shows; it uses the other.</summary>
    public BearingJacobian BearingJacobian { get; }

    /// <summary>Sets how wrong the time of the pictures from here on is, beside the budget.</summary>
    public void SetTimeNoise(TimeSpan ofPicture)
    {
        (double budget, double picture) = (_budget.TimeNoise.ExactSeconds, ofPicture.ExactSeconds);
        _random[(int)ViewingParameter.Time] = Math.Sqrt((budget * budget) + (picture * picture));
    }

    /// <summary>The projection of a picture's pixels to the ground.</summary>
    /// <param name="pose">At mid-exposure.</param>
    /// <param name="command">Where the gimbal points, and how high flat ground is.</param>
    public GroundProjection At(in Pose pose, in ImagingCommand command) => new(this, pose, command);

    /// <summary>
    /// Standard deviations of the random errors, in the order of <see cref="ViewingParameter"/>; valid until the next
    /// call.
    /// </summary>
    /// <param name="extrapolatedSeconds">
    /// How far the pose was extrapolated: it is wrong by what the vehicle may have done since.
    /// </param>
    public double[] RandomErrors(double extrapolatedSeconds)
    {
        if (extrapolatedSeconds <= 0)
            return _random;
        double t = extrapolatedSeconds;
        Array.Copy(_random, _extrapolated, _random.Length);
        for (ViewingParameter input = ViewingParameter.North; input <= ViewingParameter.Yaw; input++)
        {
            double rate = input <= ViewingParameter.Down
                ? _budget.AccelerationMetresPerSecondSquared
                : _budget.AngularAccelerationRadiansPerSecondSquared;
            double drift = 0.5 * rate * t * t;
            _extrapolated[(int)input] = Math.Sqrt((_random[(int)input] * _random[(int)input]) + (drift * drift));
        }

        return _extrapolated;
    }

    /// <summary>
    /// The same, with the errors of a pixel's place that its detector states; their covariance is not in it.
    /// </summary>
    /// <param name="extrapolatedSeconds">How far the pose was extrapolated.</param>
    /// <param name="pixel">Positive definite.</param>
    public double[] RandomErrors(double extrapolatedSeconds, in PixelCovariance pixel)
    {
        Array.Copy(RandomErrors(extrapolatedSeconds), _ofDetection, _ofDetection.Length);
        _ofDetection[(int)ViewingParameter.Column] = Math.Sqrt(pixel.ColumnColumn);
        _ofDetection[(int)ViewingParameter.Row] = Math.Sqrt(pixel.RowRow);
        return _ofDetection;
    }

    /// <summary>
    /// Standard deviations of the systematic errors, in the order of <see cref="ViewingParameter"/>; valid until the
    /// next call.
    /// </summary>
    /// <param name="timeErrorSeconds">
    /// How far all times of the poses may be off, which no exchange of times can show: half of the difference of the
    /// two ways of the link.
    /// </param>
    public double[] SystematicErrors(double timeErrorSeconds)
    {
        _systematic[(int)ViewingParameter.Time] = timeErrorSeconds;
        return _systematic;
    }

    private static double[] Random(ErrorBudget budget)
    {
        var sigmas = new double[GroundJacobian.Inputs];
        sigmas[(int)ViewingParameter.North] = sigmas[(int)ViewingParameter.East] = budget.PositionNoiseMetres;
        sigmas[(int)ViewingParameter.Down] = budget.AltitudeNoiseMetres;
        sigmas[(int)ViewingParameter.Roll] = sigmas[(int)ViewingParameter.Pitch] = budget.AttitudeNoise.Radians;
        sigmas[(int)ViewingParameter.Yaw] = budget.HeadingNoise.Radians;
        sigmas[(int)ViewingParameter.Column] = sigmas[(int)ViewingParameter.Row] = budget.PixelNoise;
        sigmas[(int)ViewingParameter.Time] = budget.TimeNoise.ExactSeconds;
        return sigmas;
    }

    private static double[] Systematic(ErrorBudget budget, CameraModel camera)
    {
        var sigmas = new double[GroundJacobian.Inputs];
        sigmas[(int)ViewingParameter.North] = sigmas[(int)ViewingParameter.East] = budget.PositionBiasMetres;
        sigmas[(int)ViewingParameter.GroundHeight] = budget.AltitudeBiasMetres;
        sigmas[(int)ViewingParameter.Roll] = sigmas[(int)ViewingParameter.Pitch] = budget.AttitudeBias.Radians;
        sigmas[(int)ViewingParameter.Yaw] = budget.HeadingBias.Radians;
        for (ViewingParameter input = ViewingParameter.MountRoll; input <= ViewingParameter.MountYaw; input++)
            sigmas[(int)input] = budget.MountBias.Radians;
        sigmas[(int)ViewingParameter.FocalLength] = Math.Sqrt(
            (budget.FocalLengthBias * budget.FocalLengthBias) + (camera.FocalLengthError * camera.FocalLengthError));
        return sigmas;
    }
}

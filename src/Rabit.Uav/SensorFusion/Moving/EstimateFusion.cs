using System;
using System.Collections.Generic;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// Tracks of other vehicles against ours, by covariance intersection: both may be made of the same reports. Fixed room;
/// for one thread.
/// </summary>
internal sealed class EstimateFusion
{
    private const int N = 4;

    // Chi-square of four, 99.9 %.
    private const double Gate = 18.47;

    // What is further off than this, beside what both may be uncertain, is another target: a cheap look first.
    private const double MaxSpeed = 60;
    private const double MaxDeviation = 6;

    private readonly MotionFilter _there = new();
    private readonly double[] _state = new double[N];
    private readonly double[] _covariance = new double[N * N];
    private readonly double[] _fusedState = new double[N];
    private readonly double[] _fusedCovariance = new double[N * N];
    private readonly EstimateCorrelations _correlations = new();

    /// <summary>Our track of the target of an estimate: the nearest one that may be; null for none.</summary>
    public MovingTrack? Find(List<MovingTrack> tracks, ForeignEstimate estimate)
    {
        MovingTrack? nearest = null;
        double least = Gate;
        foreach (MovingTrack track in tracks)
        {
            bool mayBe = track.Class == estimate.Class
                && (track.Marker < 0 || estimate.Marker < 0 || track.Marker == estimate.Marker);
            if (!mayBe || IsFarOff(track, estimate)
                || !(Distance(track, estimate) is var distance && distance <= least))
                continue;
            (nearest, least) = (track, distance);
        }

        return nearest;
    }

    /// <summary>Goes on with both; false where that cannot be.</summary>
    public bool TryFuse(MovingTrack track, ForeignEstimate estimate, MotionModel model)
    {
        Predict(track, estimate.Time);
        if (!CovarianceIntersection.TryFuse(
            _state, _covariance, estimate.State, estimate.Covariance, _fusedState, _fusedCovariance, out double own))
            return false;
        RegistrationSlots slots = track.Filter.Slots;
        _ = slots.Of(estimate.Source, estimate.Registration);
        _correlations.Find(_there, _covariance, own, estimate, _fusedCovariance, slots);
        track.GoOnFrom(estimate, model, _fusedState, _fusedCovariance, _correlations.All);
        return true;
    }

    /// <summary>Starts a track that is known from an estimate alone.</summary>
    public void Start(MovingTrack track, int id, ForeignEstimate estimate, MotionModel model, double existence)
    {
        track.Start(id, estimate, model, existence);
        RegistrationSlots slots = track.Filter.Slots;
        _ = slots.Of(estimate.Source, estimate.Registration);
        _correlations.Find(estimate, slots);
        track.GoOnFrom(estimate, model, estimate.State, estimate.Covariance, _correlations.All);
    }

    private void Predict(MovingTrack track, TimeSpan time)
    {
        track.Filter.PredictTo(time, _there);
        (_state[0], _state[1], _state[2], _state[3]) =
            (_there.North, _there.NorthRate, _there.East, _there.EastRate);
        _there.CopyCovarianceTo(_covariance);
    }

    private static bool IsFarOff(MovingTrack track, ForeignEstimate estimate)
    {
        MotionFilter here = track.Filter.Current;
        HorizontalCovariance own = here.PositionCovariance;
        double variance = Math.Max(own.NorthNorth, own.EastEast)
            + Math.Max(estimate.Covariance[0], estimate.Covariance[10]);
        double reach = (MaxDeviation * Math.Sqrt(variance))
            + (MaxSpeed * Math.Abs((estimate.Time - track.LastSeen).ExactSeconds));
        return Math.Abs(estimate.State[0] - here.North) > reach || Math.Abs(estimate.State[2] - here.East) > reach;
    }

    private double Distance(MovingTrack track, ForeignEstimate estimate)
    {
        Predict(track, estimate.Time);
        Span<double> sum = stackalloc double[N * N];
        Span<double> inverse = stackalloc double[N * N];
        for (int i = 0; i < sum.Length; i++)
            sum[i] = _covariance[i] + estimate.Covariance[i];
        if (!CovarianceIntersection.TryInvert(sum, N, inverse))
            return double.PositiveInfinity;
        double distance = 0;
        for (int row = 0; row < N; row++)
        {
            for (int column = 0; column < N; column++)
            {
                distance += (estimate.State[row] - _state[row]) * inverse[(row * N) + column]
                    * (estimate.State[column] - _state[column]);
            }
        }

        return distance;
    }
}

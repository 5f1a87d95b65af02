using System;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// How the error of a state that another vehicle has a part in depends on the registration error of each source, so
/// that further reports of a source, which are off by the same, do not make a track surer than its frame is. With
/// covariance intersection, w Pa^-1 + (1 - w) Pb^-1 = P^-1, that is C = P (w Pa^-1 Ca + (1 - w) Pb^-1 Cb). Fixed room;
/// for one thread.
/// </summary>
/// <remarks>
/// Nothing says of whose reports the state of the other vehicle is made. They may all be of one source that is known
/// here, so Cb is as much as the covariance that was sent allows, -s B at the place with s up to 1: less would be too
/// sure where that is so, and this is only less sure than need be where it is not.
/// </remarks>
internal sealed class EstimateCorrelations
{
    private const int N = 4;
    private const int Size = N * 2;

    private readonly double[] _all = new double[RegistrationSlots.Capacity * Size];

    /// <summary>The last ones that were found: eight numbers for each slot, four rows of two.</summary>
    public ReadOnlySpan<double> All => _all;

    /// <summary>For a state that is that of the other vehicle alone.</summary>
    /// <param name="estimate">That of the other vehicle.</param>
    /// <param name="slots">The sources; that vehicle among them where it found room.</param>
    public void Find(ForeignEstimate estimate, RegistrationSlots slots)
    {
        for (int slot = 0; slot < slots.Count; slot++)
            OfEstimate(estimate, slots, slot, _all.AsSpan(slot * Size, Size));
    }

    /// <summary>For a fused state.</summary>
    /// <param name="own">Our filter at the time of the estimate.</param>
    /// <param name="ownCovariance">Its covariance, positive definite.</param>
    /// <param name="weight">What it counts, 0 to 1.</param>
    /// <param name="estimate">That of the other vehicle.</param>
    /// <param name="fused">The covariance of both together.</param>
    /// <param name="slots">The sources; that vehicle among them where it found room.</param>
    public void Find(
        MotionFilter own,
        ReadOnlySpan<double> ownCovariance,
        double weight,
        ForeignEstimate estimate,
        ReadOnlySpan<double> fused,
        RegistrationSlots slots)
    {
        Span<double> ofOwn = stackalloc double[N * N];
        Span<double> ofOther = stackalloc double[N * N];
        _ = CovarianceIntersection.TryInvert(ownCovariance, N, ofOwn);
        _ = CovarianceIntersection.TryInvert(estimate.Covariance, N, ofOther);
        Span<double> c = stackalloc double[Size];
        Span<double> sum = stackalloc double[Size];
        for (int slot = 0; slot < slots.Count; slot++)
        {
            sum.Clear();
            own.CopyCorrelationTo(slot, c);
            AddProduct(weight, ofOwn, c, sum);
            OfEstimate(estimate, slots, slot, c);
            AddProduct(1 - weight, ofOther, c, sum);
            Span<double> result = _all.AsSpan(slot * Size, Size);
            result.Clear();
            AddProduct(1, fused, sum, result);
        }
    }

    private static void OfEstimate(ForeignEstimate estimate, RegistrationSlots slots, int slot, Span<double> c)
    {
        c.Clear();
        int sender = slots.Find(estimate.Source);
        HorizontalCovariance b = slots[slot];
        double share = 1;
        if (slot != sender)
            share = MaxShare(estimate.SentCovariance, b, sender < 0 ? slots.Count : slots.Count - 1);
        else if (estimate.Registration.NorthNorth + estimate.Registration.EastEast < b.NorthNorth + b.EastEast)
            b = estimate.Registration;
        (c[0], c[1], c[4], c[5]) =
            (-share * b.NorthNorth, -share * b.NorthEast, -share * b.NorthEast, -share * b.EastEast);
    }

    // The largest s for which the state and so many registration errors still have a joint covariance: s^2 n B is
    // nowhere above what the place is uncertain by itself, the inverse of M = H P^-1 H'. The larger eigenvalue of B M.
    private static double MaxShare(ReadOnlySpan<double> sent, HorizontalCovariance b, int sources)
    {
        Span<double> m = stackalloc double[N * N];
        if (!CovarianceIntersection.TryInvert(sent, N, m))
            return 0;
        double trace = (b.NorthNorth * m[0]) + (2 * b.NorthEast * m[2]) + (b.EastEast * m[10]);
        double determinant = ((b.NorthNorth * b.EastEast) - (b.NorthEast * b.NorthEast))
            * ((m[0] * m[10]) - (m[2] * m[2]));
        double largest = (trace / 2) + Math.Sqrt(Math.Max(0, (trace * trace / 4) - determinant));
        return 1 / Math.Sqrt(Math.Max(1, sources * largest));
    }

    private static void AddProduct(
        double weight, ReadOnlySpan<double> matrix, ReadOnlySpan<double> c, Span<double> sum)
    {
        for (int row = 0; row < N; row++)
        {
            for (int k = 0; k < N; k++)
            {
                double factor = weight * matrix[(row * N) + k];
                sum[row * 2] += factor * c[k * 2];
                sum[(row * 2) + 1] += factor * c[(k * 2) + 1];
            }
        }
    }
}

using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>The state of a track of another vehicle in our local frame; used again and again, for one thread.</summary>
internal sealed class ForeignEstimate
{
    private const int N = 4;

    public byte Source { get; private set; }

    public int Class { get; private set; }

    /// <summary>Negative for none.</summary>
    public int Marker { get; private set; }

    public TimeSpan Time { get; private set; }

    /// <summary>Metres below the origin.</summary>
    public double Down { get; private set; }

    /// <summary>N, vN, E, vE.</summary>
    public double[] State { get; } = new double[N];

    /// <summary>
    /// Sixteen numbers, row by row: that of the other vehicle, and what its frame is off from ours.
    /// </summary>
    public double[] Covariance { get; } = new double[N * N];

    /// <summary>That of the other vehicle alone, as it sent it.</summary>
    public double[] SentCovariance { get; } = new double[N * N];

    /// <summary>What the frame of the other vehicle is off, which is in all that it says.</summary>
    public HorizontalCovariance Registration { get; private set; }

    /// <summary>Takes one, valid.</summary>
    /// <param name="estimate">The estimate.</param>
    /// <param name="place">Where that is in our frame.</param>
    /// <param name="ofClass">The number of its class.</param>
    /// <param name="registration">What the frame of its vehicle is off from ours.</param>
    public void Set(in TrackEstimate estimate, NedPosition place, int ofClass, HorizontalCovariance registration)
    {
        (Source, Time, Class, Marker) = (estimate.SourceSystemId, estimate.Time, ofClass, estimate.MarkerId ?? -1);
        (State[0], State[1]) = (place.North, estimate.VelocityNed.North);
        (State[2], State[3]) = (place.East, estimate.VelocityNed.East);
        (Down, Registration) = (place.Down, registration);
        CopyCovariance(estimate, SentCovariance);
        SentCovariance.CopyTo(Covariance, 0);
        Covariance[0] += registration.NorthNorth;
        Covariance[2] += registration.NorthEast;
        Covariance[8] += registration.NorthEast;
        Covariance[10] += registration.EastEast;
    }

    /// <summary>That of an estimate as it was sent, row by row.</summary>
    public static void CopyCovariance(in TrackEstimate estimate, Span<double> p)
    {
        (p[0], p[2], p[10]) = (
            estimate.Covariance.NorthNorth, estimate.Covariance.NorthEast, estimate.Covariance.EastEast);
        (p[5], p[7], p[15]) = (
            estimate.VelocityCovariance.NorthNorth, estimate.VelocityCovariance.NorthEast,
            estimate.VelocityCovariance.EastEast);
        (p[1], p[3]) = (estimate.NorthWithNorthRate, estimate.NorthWithEastRate);
        (p[6], p[11]) = (estimate.EastWithNorthRate, estimate.EastWithEastRate);
        for (int row = 1; row < N; row++)
        {
            for (int column = 0; column < row; column++)
                p[(row * N) + column] = p[(column * N) + row];
        }
    }
}

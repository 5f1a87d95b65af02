using System;
using Rabit.Geodesy;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// How far the direction between two pixels on the ground turns for a small error of each thing that it is computed
/// from. Fixed memory; for one thread.
/// </summary>
internal sealed class BearingJacobian(GroundJacobian ofPlace)
{
    private readonly NedVector[] _start = new NedVector[GroundJacobian.Inputs];
    private readonly double[] _turn = new double[GroundJacobian.Inputs];

    /// <summary>Computes all derivatives; false where one of the two rays misses the ground.</summary>
    /// <param name="geometry">Of the picture, on the ground where the pixels lie.</param>
    /// <param name="from">Pixel where the direction begins.</param>
    /// <param name="to">Pixel to which it points.</param>
    /// <param name="way">From the one to the other on the ground, metres.</param>
    public bool TryCompute(
        in ViewingGeometry geometry, (double Column, double Row) from, (double Column, double Row) to, NedVector way)
    {
        if (!ofPlace.TryCompute(geometry, from.Column, from.Row))
            return false;
        for (int input = 0; input < _start.Length; input++)
            _start[input] = ofPlace.By((ViewingParameter)input);
        if (!ofPlace.TryCompute(geometry, to.Column, to.Row))
            return false;
        double square = (way.North * way.North) + (way.East * way.East);
        for (int input = 0; input < _turn.Length; input++)
        {
            NedVector moved = ofPlace.By((ViewingParameter)input) - _start[input];
            _turn[input] = ((way.North * moved.East) - (way.East * moved.North)) / square;
        }

        // How well a detector knows the direction in the picture is its own statement.
        _turn[(int)ViewingParameter.Column] = _turn[(int)ViewingParameter.Row] = 0;
        return true;
    }

    /// <summary>Of the direction, radians, for independent errors of the given standard deviations.</summary>
    public double Variance(double[] sigmas)
    {
        double variance = 0;
        for (int input = 0; input < _turn.Length; input++)
            variance += sigmas[input] * sigmas[input] * _turn[input] * _turn[input];
        return variance;
    }
}

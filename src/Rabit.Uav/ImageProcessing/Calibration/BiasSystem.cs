using System;
using System.Collections.Generic;
using Rabit.Geodesy;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>
/// The normal equations of a <see cref="BiasEstimator"/>: biases first, then two for each point. For one thread.
/// </summary>
internal sealed class BiasSystem
{
    private const int Biases = BiasModel.Biases;
    private const int Inputs = BiasModel.Inputs;

    private readonly BiasModel _model;
    private readonly BiasOptions _options;
    private readonly double[] _priors;
    private readonly List<BiasObservation> _observations;
    private readonly int[] _points;
    private readonly NedPosition[] _vehicles;
    private readonly double[] _weights;
    private readonly double _groundDown;
    private readonly int _size;
    private readonly double[] _byColumn = new double[Inputs];
    private readonly double[] _byRow = new double[Inputs];
    private readonly double[] _at = new double[Inputs];
    private double _squares;
    private double _normalised;
    private int _used;

    public BiasSystem(
        BiasModel model, BiasOptions options, double[] priors, List<BiasObservation> observations, int[] points,
        in LocalNedFrame frame, double groundDown)
    {
        (_model, _options, _priors, _observations, _points, _groundDown) =
            (model, options, priors, observations, points, groundDown);
        _vehicles = new NedPosition[observations.Count];
        int last = 0;
        for (int i = 0; i < observations.Count; i++)
        {
            _vehicles[i] = frame.ToNed(observations[i].Position);
            last = Math.Max(last, points[i]);
        }

        _weights = Weights(observations, options.NoiseTime.ExactSeconds);
        _size = Biases + (2 * (last + 1));
        Values = new double[_size];
    }

    /// <summary>The estimate so far.</summary>
    public double[] Values { get; }

    /// <summary>One step of Gauss and Newton.</summary>
    /// <returns>The largest change, in standard deviations of the prior or metres.</returns>
    public double Step()
    {
        double[,]? inverse = SymmetricMatrix.Invert(Assemble(out double[] right));
        if (inverse is null)
            return 0;
        double largest = 0;
        for (int i = 0; i < _size; i++)
        {
            double change = 0;
            for (int j = 0; j < _size; j++)
                change += inverse[i, j] * right[j];
            Values[i] += change;
            double unit = i < Biases ? _priors[i] : 1;
            largest = unit > 0 ? Math.Max(largest, Math.Abs(change) / unit) : largest;
        }

        return largest;
    }

    /// <summary>The covariance of all.</summary>
    public double[,] Finish(out BiasFit fit)
    {
        double[,] covariance = SymmetricMatrix.Invert(Assemble(out _)) ?? new double[_size, _size];
        for (int i = 0; i < Biases; i++)
        {
            for (int j = 0; j < _size; j++)
            {
                if (_priors[i] == 0)
                    covariance[i, j] = covariance[j, i] = 0;
            }
        }

        fit = new BiasFit(_used, 0, Math.Sqrt(_squares / Math.Max(1, 2 * _used)), _normalised / Math.Max(1, 2 * _used));
        return covariance;
    }

    // How much an observation counts among those whose noise is alike: n observations in a row with correlations r
    // count as n / (1 + sum of r).
    private static double[] Weights(List<BiasObservation> observations, double noiseSeconds)
    {
        var weights = new double[observations.Count];
        for (int i = 0; i < weights.Length; i++)
        {
            double alike = 0;
            foreach (BiasObservation other in observations)
            {
                double apart = Math.Abs((other.Time - observations[i].Time).ExactSeconds);
                alike += noiseSeconds > 0 ? Math.Exp(-apart / noiseSeconds) : apart == 0 ? 1 : 0;
            }

            weights[i] = 1 / alike;
        }

        return weights;
    }

    private double[,] Assemble(out double[] right)
    {
        var matrix = new double[_size, _size];
        right = new double[_size];
        for (int i = 0; i < Biases; i++)
        {
            // What is not estimated is held so that it does not move.
            double weight = _priors[i] > 0 ? 1 / (_priors[i] * _priors[i]) : 1e24;
            matrix[i, i] = weight;
            right[i] = -weight * Values[i];
        }

        (_squares, _normalised, _used) = (0, 0, 0);
        for (int i = 0; i < _observations.Count; i++)
            AddObservation(i, matrix, right);
        for (int i = Biases; i < _size; i++)
            matrix[i, i] += 1e-12;
        return matrix;
    }

    private void AddObservation(int index, double[,] matrix, double[] right)
    {
        BiasObservation observation = _observations[index];
        int point = Biases + (2 * _points[index]);
        Array.Copy(Values, _at, Biases);
        (_at[Biases], _at[Biases + 1]) = (Values[point], Values[point + 1]);
        if (!_model.TryProject(observation, _vehicles[index], _groundDown, _at, out double column, out double row)
            || !_model.TryDerive(observation, _vehicles[index], _groundDown, _at, _byColumn, _byRow))
            return;
        (double residualColumn, double residualRow) = (observation.Column - column, observation.Row - row);
        Noise(out double cc, out double cr, out double rr);
        double determinant = (cc * rr) - (cr * cr);
        (double wcc, double wcr, double wrr) = (rr / determinant, -cr / determinant, cc / determinant);
        _used++;
        _squares += (residualColumn * residualColumn) + (residualRow * residualRow);
        _normalised += (wcc * residualColumn * residualColumn) + (2 * wcr * residualColumn * residualRow)
            + (wrr * residualRow * residualRow);
        double weight = _weights[index];
        for (int i = 0; i < Inputs; i++)
        {
            double left = weight * ((_byColumn[i] * wcc) + (_byRow[i] * wcr));
            double leftRow = weight * ((_byColumn[i] * wcr) + (_byRow[i] * wrr));
            int a = i < Biases ? i : point + i - Biases;
            right[a] += (left * residualColumn) + (leftRow * residualRow);
            for (int j = 0; j < Inputs; j++)
                matrix[a, j < Biases ? j : point + j - Biases] += (left * _byColumn[j]) + (leftRow * _byRow[j]);
        }
    }

    // Pixels, and what the noise of attitude and position makes of them.
    private void Noise(out double cc, out double cr, out double rr)
    {
        double pixel = _options.PixelNoise * _options.PixelNoise;
        (cc, cr, rr) = (pixel, 0, pixel);
        for (int i = (int)BiasParameter.AttitudeRoll; i < Biases; i++)
        {
            double sigma = i <= (int)BiasParameter.AttitudeYaw ? _options.AttitudeNoise.Radians
                : i >= (int)BiasParameter.North ? _options.PositionNoiseMetres : 0;
            double variance = sigma * sigma;
            cc += variance * _byColumn[i] * _byColumn[i];
            cr += variance * _byColumn[i] * _byRow[i];
            rr += variance * _byRow[i] * _byRow[i];
        }
    }
}

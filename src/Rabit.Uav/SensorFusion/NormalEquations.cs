using System;

namespace Rabit.Uav.SensorFusion;

/// <summary>Least squares with a few unknowns that are expected to be near 0. Fixed memory; for one thread.</summary>
internal sealed class NormalEquations(double[] sigmas)
{
    private readonly int _n = sigmas.Length;
    private readonly double[,] _normal = new double[sigmas.Length, sigmas.Length];
    private readonly double[] _right = new double[sigmas.Length];
    private readonly double[] _solution = new double[sigmas.Length];
    private double _squares;

    /// <summary>The solution.</summary>
    public ReadOnlySpan<double> Solution => _solution;

    /// <summary>The weighted squares that are left, with those of the unknowns against what was expected.</summary>
    public double SquaresLeft { get; private set; }

    /// <summary>Starts over: each unknown is 0, with its standard deviation.</summary>
    public void Clear()
    {
        Array.Clear(_normal, 0, _normal.Length);
        Array.Clear(_right, 0, _n);
        for (int i = 0; i < _n; i++)
            _normal[i, i] = 1 / (sigmas[i] * sigmas[i]);
        _squares = 0;
    }

    /// <summary>Adds an observation: the derivatives by the unknowns, and what was observed.</summary>
    public void Add(ReadOnlySpan<double> derivatives, double observed, double weight)
    {
        for (int i = 0; i < _n; i++)
        {
            _right[i] += weight * derivatives[i] * observed;
            for (int j = 0; j < _n; j++)
                _normal[i, j] += weight * derivatives[i] * derivatives[j];
        }

        _squares += weight * observed * observed;
    }

    /// <summary>Solves, and says how uncertain the first unknown is; the equations are used up.</summary>
    /// <param name="variance">Of the first unknown.</param>
    /// <returns>False where they have no solution.</returns>
    public bool TrySolve(out double variance)
    {
        InvertInPlace();
        variance = _normal[0, 0];
        SquaresLeft = _squares;
        for (int i = 0; i < _n; i++)
        {
            _solution[i] = 0;
            for (int j = 0; j < _n; j++)
                _solution[i] += _normal[i, j] * _right[j];
            SquaresLeft -= _solution[i] * _right[i];
        }

        return variance > 0 && !double.IsInfinity(variance) && !double.IsNaN(SquaresLeft);
    }

    // Gauss and Jordan without exchanges: the matrix is positive definite.
    private void InvertInPlace()
    {
        for (int k = 0; k < _n; k++)
        {
            double pivot = 1 / _normal[k, k];
            _normal[k, k] = 1;
            for (int j = 0; j < _n; j++)
                _normal[k, j] *= pivot;
            for (int i = 0; i < _n; i++)
            {
                if (i == k)
                    continue;
                double factor = _normal[i, k];
                _normal[i, k] = 0;
                for (int j = 0; j < _n; j++)
                    _normal[i, j] -= factor * _normal[k, j];
            }
        }
    }
}

using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// The offset of the camera's clock by least squares over passes of known targets: the place of each target is
/// eliminated; the errors of attitude, heading and height are estimated beside it, held near 0 by what they usually
/// are.
/// </summary>
internal sealed class CameraClockFit
{
    // What satellite positions walk by between two passes, minutes apart, and the lens: each axis.
    private const double FloorMetres = 0.25;

    // Attitude and mount together, heading, height of the ground: ErrorBudget's defaults. The time is unknown.
    private static readonly double[] Sigmas = [100, 0.8 * Math.PI / 180, 0.8 * Math.PI / 180, 1.2 * Math.PI / 180, 1.5];

    // A mount that is off by more than that is seen before the flight.
    private const double FreePitch = 10 * Math.PI / 180;
    private const double CertainSigmas = 3;

    // Chi-square with two degrees of freedom, 99.9 %: a pass that is further from its target is of another one.
    private const double Gate = 13.8;

    // So many figures, two of each pass, are to agree beyond those that are estimated: two different targets that
    // happen to lie one speed apart are no offset.
    private const int MinRedundancy = 9;
    private const int Rounds = 3;
    private const int N = TargetPass.Others + 1;

    private readonly double[] _errors = new double[N];
    private readonly NormalEquations _equations = new(Sigmas);
    private readonly NormalEquations _freeMount = new([Sigmas[0], FreePitch, Sigmas[2], Sigmas[3], Sigmas[4]]);
    private readonly List<TargetPass> _first = [];
    private readonly List<int> _targetOf = [];

    /// <summary>How far two passes of one target may differ but for the time, each axis, square metres.</summary>
    public static double VarianceOf(TargetPass a, TargetPass b)
    {
        double variance = a.Variance + b.Variance + (2 * FloorMetres * FloorMetres);
        for (int i = 1; i < N; i++)
        {
            NedVector by = a.By(i - 1) - b.By(i - 1);
            variance += Sigmas[i] * Sigmas[i] * ((by.North * by.North) + (by.East * by.East)) / 2;
        }

        return variance;
    }

    /// <summary>Fits; not known where the passes do not suffice.</summary>
    public CameraClockEstimate Fit(IReadOnlyList<TargetPass> passes, double firstGuess)
    {
        Array.Clear(_errors, 0, N);
        _errors[0] = firstGuess;
        CameraClockEstimate estimate = default;
        for (int round = 0; round < Rounds; round++)
        {
            Group(passes);
            estimate = Solve(passes, _equations);
            if (!estimate.IsKnown)
                return estimate;
        }

        CameraClockEstimate free = Solve(passes, _freeMount);
        estimate.ExcludesMount = Math.Abs(free.OffsetSeconds) > CertainSigmas * free.ErrorSeconds;
        return estimate;
    }

    // Each pass to the first target that it fits at the present estimate of the errors.
    private void Group(IReadOnlyList<TargetPass> passes)
    {
        _first.Clear();
        _targetOf.Clear();
        foreach (TargetPass pass in passes)
        {
            int target = -1;
            if (TryPlace(pass, out NedVector place))
            {
                target = 0;
                while (target < _first.Count && !AreOne(_first[target], pass, place))
                    target++;
                if (target == _first.Count)
                    _first.Add(pass);
            }

            _targetOf.Add(target);
        }
    }

    private bool AreOne(TargetPass first, TargetPass pass, NedVector place)
    {
        if (first.Class != pass.Class || !TryPlace(first, out NedVector there))
            return false;
        NedVector apart = there - place;
        return (apart.North * apart.North) + (apart.East * apart.East) <= Gate * VarianceOf(first, pass);
    }

    // Where it is by the errors that are known so far.
    private bool TryPlace(TargetPass pass, out NedVector place)
    {
        bool isKnown = pass.TryPlace(_errors[0], out place, out _);
        for (int i = 1; i < N; i++)
            place -= _errors[i] * pass.By(i - 1);
        return isKnown;
    }

    private CameraClockEstimate Solve(IReadOnlyList<TargetPass> passes, NormalEquations equations)
    {
        equations.Clear();
        (int targets, int used) = (0, 0);
        for (int target = 0; target < _first.Count; target++)
        {
            int count = AddTarget(passes, target, equations);
            (targets, used) = count > 1 ? (targets + 1, used + count) : (targets, used);
        }

        int redundancy = (2 * (used - targets)) - 1;
        if (redundancy < MinRedundancy || !equations.TrySolve(out double variance))
            return default;
        double before = _errors[0];
        equations.Solution.CopyTo(_errors);
        _errors[0] += before;
        double scale = Math.Max(1, equations.SquaresLeft / redundancy);
        return new CameraClockEstimate
        {
            OffsetSeconds = _errors[0],
            ErrorSeconds = Math.Sqrt(scale * variance),
            Passes = used,
            Targets = targets,
        };
    }

    // Its place is eliminated by what the passes differ from their weighted mean. Returns how many there are.
    private int AddTarget(IReadOnlyList<TargetPass> passes, int target, NormalEquations equations)
    {
        (int count, double weights) = (0, 0);
        Span<double> mean = stackalloc double[2 * (N + 1)];
        mean.Clear();
        for (int p = 0; p < passes.Count; p++)
        {
            if (_targetOf[p] != target)
                continue;
            double weight = WeightOf(passes[p]);
            count++;
            weights += weight;
            for (int k = 0; k < mean.Length; k++)
                mean[k] += weight * Figure(passes[p], k);
        }

        if (count < 2)
            return count;
        Span<double> row = stackalloc double[2 * (N + 1)];
        for (int p = 0; p < passes.Count; p++)
        {
            if (_targetOf[p] != target)
                continue;
            for (int k = 0; k < row.Length; k++)
                row[k] = Figure(passes[p], k) - (mean[k] / weights);
            equations.Add(row.Slice(0, N), row[N], WeightOf(passes[p]));
            equations.Add(row.Slice(N + 1, N), row[(2 * N) + 1], WeightOf(passes[p]));
        }

        return count;
    }

    // North by each error and north itself, then the same of east. A wrong time moves the place the other way round:
    // what is given is where it would be without.
    private double Figure(TargetPass pass, int index)
    {
        int i = index % (N + 1);
        pass.TryPlace(_errors[0], out NedVector place, out NedVector byTime);
        NedVector of = i == 0 ? -1 * byTime : i < N ? pass.By(i - 1) : place;
        return index <= N ? of.North : of.East;
    }

    private static double WeightOf(TargetPass pass) => 1 / (pass.Variance + (FloorMetres * FloorMetres));
}

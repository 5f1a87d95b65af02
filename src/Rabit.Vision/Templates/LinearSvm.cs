using System;
using System.Collections.Generic;
using System.Threading;

namespace Rabit.Vision;

/// <summary>
/// A linear support vector machine, trained by coordinate descent in the dual (C.-J. Hsieh et al., "A Dual Coordinate
/// Descent Method for Large-scale Linear SVM", ICML 2008, algorithm 1, L1 loss). The same samples give the same
/// weights.
/// </summary>
internal static class LinearSvm
{
    // The constant feature behind the bias: larger than 1, so that the bias costs little.
    private const double BiasFeature = 3;
    private const int MaxEpochs = 200;
    private const double Tolerance = 0.02;

    /// <summary>Trains.</summary>
    /// <param name="positives">Features of what is the object; all arrays have one length.</param>
    /// <param name="negatives">Features of what is not.</param>
    /// <param name="penalty">Of a sample on the wrong side: C.</param>
    /// <param name="cancellation">Ends it.</param>
    public static (float[] Weights, double Bias) Train(
        List<float[]> positives, List<float[]> negatives, double penalty, CancellationToken cancellation)
    {
        int count = positives.Count + negatives.Count;
        float[][] samples = [.. positives, .. negatives];
        double[] alpha = new double[count];
        double[] diagonal = new double[count];
        int[] order = new int[count];
        float[] weights = new float[samples[0].Length];
        double bias = 0;
        for (int i = 0; i < count; i++)
            (diagonal[i], order[i]) = (FloatRows.Dot(samples[i], samples[i]) + (BiasFeature * BiasFeature), i);
        var random = new SampleRandom(1);
        for (int epoch = 0; epoch < MaxEpochs; epoch++)
        {
            cancellation.ThrowIfCancellationRequested();
            random.Shuffle(order);
            double largest = 0;
            foreach (int i in order)
            {
                double side = i < positives.Count ? 1 : -1;
                double gradient = (side * (FloatRows.Dot(weights, samples[i]) + (bias * BiasFeature))) - 1;
                double allowed = alpha[i] <= 0 ? Math.Min(gradient, 0)
                    : alpha[i] >= penalty ? Math.Max(gradient, 0)
                    : gradient;
                if (allowed == 0)
                    continue;
                largest = Math.Max(largest, Math.Abs(allowed));
                double next = Math.Min(Math.Max(alpha[i] - (gradient / diagonal[i]), 0), penalty);
                double step = (next - alpha[i]) * side;
                alpha[i] = next;
                FloatRows.AddMultiple(weights, samples[i], (float)step);
                bias += step * BiasFeature;
            }

            if (largest < Tolerance)
                break;
        }

        return (weights, bias * BiasFeature);
    }
}

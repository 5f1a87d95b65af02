using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Noise with a memory (Ornstein-Uhlenbeck): a standard deviation, and the time after which it has forgotten itself
/// by 1/e.
/// </summary>
internal sealed class ColouredNoise
{
    private readonly SimulationRandom _random;
    private readonly double _kept;
    private readonly double _added;

    /// <param name="random">Shared with other noises of the same purpose.</param>
    /// <param name="sigma">Standard deviation in the long run.</param>
    /// <param name="timeConstant">Seconds.</param>
    /// <param name="step">Seconds between two calls of <see cref="Step"/>.</param>
    /// <param name="startsAtZero">Whether it begins at 0 and grows, or as if it had always been there.</param>
    public ColouredNoise(
        SimulationRandom random, double sigma, double timeConstant, double step, bool startsAtZero = false)
    {
        _random = random;
        _kept = Math.Exp(-step / timeConstant);
        _added = sigma * Math.Sqrt(1 - (_kept * _kept));
        Value = startsAtZero ? 0 : sigma * random.Normal();
    }

    public double Value { get; private set; }

    /// <summary>The next value.</summary>
    /// <param name="scale">Makes the noise that comes in now larger or smaller.</param>
    public void Step(double scale = 1) => Value = (_kept * Value) + (_added * scale * _random.Normal());
}

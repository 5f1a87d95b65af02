using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>How the value of a parameter is judged. Immutable.</summary>
internal abstract class ParameterTest
{
    /// <summary>Every value passes.</summary>
    public static ParameterTest Any { get; } = Range(double.MinValue, double.MaxValue, PreflightResult.Pass);

    /// <summary>A number that stands for an action.</summary>
    /// <param name="meanings">What each number stands for.</param>
    /// <param name="pass">The numbers that pass.</param>
    /// <param name="warn">Those that warn; all others fail.</param>
    public static ParameterTest Choice(
        IReadOnlyDictionary<int, string> meanings, IReadOnlyList<int> pass, IReadOnlyList<int> warn)
        => new ChoiceTest(meanings, pass, warn);

    /// <summary>A number within bounds, both of which pass.</summary>
    public static ParameterTest Range(double min, double max, PreflightResult otherwise, string unit = "")
        => new RangeTest(min, max, otherwise, unit);

    /// <summary>A bit that is to be set, or not to be.</summary>
    public static ParameterTest Bit(int bit, bool isSet, PreflightResult otherwise)
        => new BitTest(bit, isSet, otherwise);

    /// <summary>A test of its own.</summary>
    public static ParameterTest Custom(Func<double, PreflightFacts, PreflightResult> judge, string unit = "")
        => new CustomTest(judge, unit);

    public abstract PreflightResult Judge(double value, PreflightFacts facts);

    public virtual string ValueText(double value) => value.ToString("0.###", CultureInfo.InvariantCulture);

    /// <summary>What a value stands for, in brackets behind it; empty where it is a plain number.</summary>
    public virtual string Meaning(double value) => string.Empty;

    public virtual string WantedText(double wanted) => ValueText(wanted);

    /// <summary>The value to write: bits that are not judged stay as they are.</summary>
    public virtual double Change(double value, double wanted) => wanted;

    private sealed class ChoiceTest(
        IReadOnlyDictionary<int, string> meanings, IReadOnlyList<int> pass, IReadOnlyList<int> warn) : ParameterTest
    {
        public override PreflightResult Judge(double value, PreflightFacts facts)
            => pass.Any(p => value.Equals(p)) ? PreflightResult.Pass
            : warn.Any(w => value.Equals(w)) ? PreflightResult.Warn
            : PreflightResult.Fail;

        public override string Meaning(double value)
            => meanings.TryGetValue((int)value, out string? meaning) && value.Equals((int)value)
                ? $" ({meaning})"
                : string.Empty;
    }

    private sealed class RangeTest(double min, double max, PreflightResult otherwise, string unit) : ParameterTest
    {
        public override PreflightResult Judge(double value, PreflightFacts facts)
            => value >= min && value <= max ? PreflightResult.Pass : otherwise;

        public override string ValueText(double value) => base.ValueText(value) + unit;
    }

    private sealed class BitTest(int bit, bool isSet, PreflightResult otherwise) : ParameterTest
    {
        private readonly int _mask = 1 << bit;

        public override PreflightResult Judge(double value, PreflightFacts facts)
            => (((int)value & _mask) != 0) == isSet ? PreflightResult.Pass : otherwise;

        public override string Meaning(double value)
            => $" (bit {bit.ToString(CultureInfo.InvariantCulture)} "
                + (((int)value & _mask) != 0 ? "set)" : "not set)");

        public override string WantedText(double wanted)
            => isSet ? "a value with " + base.WantedText(wanted) : "a value without " + _mask;

        public override double Change(double value, double wanted)
            => isSet ? (int)value | _mask : (int)value & ~_mask;
    }

    private sealed class CustomTest(Func<double, PreflightFacts, PreflightResult> judge, string unit) : ParameterTest
    {
        public override PreflightResult Judge(double value, PreflightFacts facts) => judge(value, facts);

        public override string ValueText(double value) => base.ValueText(value) + unit;
    }
}

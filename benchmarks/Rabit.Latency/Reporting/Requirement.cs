namespace Rabit.Latency.Reporting;

/// <summary>What was required of a figure, and what was measured.</summary>
internal sealed class Requirement(string what, double measured, double limit, string unit, bool atLeast = false)
{
    public string What => what;

    public double Measured => measured;

    public double Limit => limit;

    public string Unit => unit;

    /// <summary>Whether the limit is a least value; otherwise it is a largest.</summary>
    public bool IsMin => atLeast;

    public bool IsMet => atLeast ? measured >= limit : measured <= limit;
}

using System;
using System.Collections.Generic;
using Rabit.Latency.Measuring;

namespace Rabit.Latency.Reporting;

/// <summary>What one mode measured: a row for each subject, and what was required.</summary>
internal sealed class Table(
    string mode, string title, IReadOnlyList<Column> columns, IReadOnlyList<Subject> rows, Subject? limit = null,
    string limitName = "limit")
{
    private readonly List<Requirement> _requirements = [];

    public string Mode => mode;

    public string Title => title;

    public IReadOnlyList<Column> Columns => columns;

    public IReadOnlyList<Subject> Rows => rows;

    public IReadOnlyList<Requirement> Requirements => _requirements;

    /// <summary>The row that bounds the others; null where there is none.</summary>
    public Subject? Limit => limit;

    /// <summary>What that row is: a limit, or only what the others are set beside.</summary>
    public string LimitName => limitName;

    /// <summary>Requires that a figure is at most so many times another one, round by round.</summary>
    public void RequireRatio(Subject subject, Subject other, int column, double atMost)
        => _requirements.Add(new Requirement(
            $"{subject.Name} / {other.Name}, {columns[column].Name}",
            subject.Columns[column].RatioTo(other.Columns[column]), atMost, "x"));

    /// <summary>Requires that a figure is at least so many times another one, round by round.</summary>
    public void RequireMinRatio(Subject subject, Subject other, int column, double atLeast)
        => _requirements.Add(new Requirement(
            $"{subject.Name} / {other.Name}, {columns[column].Name}",
            subject.Columns[column].RatioTo(other.Columns[column]), atLeast, "x", atLeast: true));

    public void RequireMax(Subject subject, int column, double limitValue)
        => _requirements.Add(
            new Requirement(
                $"{subject.Name}, {columns[column].Name}", subject.Columns[column].Median, limitValue, string.Empty));

    public void RequireMin(Subject subject, int column, double limitValue)
        => _requirements.Add(
            new Requirement(
                $"{subject.Name}, {columns[column].Name}", subject.Columns[column].Median, limitValue, string.Empty,
                atLeast: true));

    /// <summary>
    /// As <see cref="RequireMin(Subject, int, double)"/>, for a figure that was set on another machine beside one
    /// written without Rabit: where that one is slower here, the ratio of the two decides.
    /// </summary>
    /// <param name="subject">What must be fast.</param>
    /// <param name="column">Its figure.</param>
    /// <param name="limitValue">The least.</param>
    /// <param name="baseline">The one without Rabit, measured in the same rounds.</param>
    /// <param name="byHandThere">What that one reached where the least value was set.</param>
    public void RequireMin(Subject subject, int column, double limitValue, Subject baseline, double byHandThere)
    {
        double slowdown = Math.Min(1, baseline.Columns[column].Median / byHandThere);
        string what = FormattableString.Invariant(
            $"{subject.Name}, {columns[column].Name}: {limitValue} where {baseline.Name} reaches {byHandThere}");
        _requirements.Add(
            new Requirement(what, subject.Columns[column].Median, limitValue * slowdown, string.Empty, atLeast: true));
    }

    /// <summary>
    /// As <see cref="RequireMin(Subject, int, double, Subject, double)"/>, for a figure that must be small.
    /// </summary>
    public void RequireMax(Subject subject, int column, double limitValue, Subject baseline, double byHandThere)
    {
        double slowdown = Math.Max(1, baseline.Columns[column].Median / byHandThere);
        string what = FormattableString.Invariant(
            $"{subject.Name}, {columns[column].Name}: {limitValue} where {baseline.Name} takes {byHandThere}");
        _requirements.Add(new Requirement(what, subject.Columns[column].Median, limitValue * slowdown, string.Empty));
    }

    /// <summary>Requires that two figures do not differ by more than so much.</summary>
    public void RequireDifference(Subject subject, Subject other, int column, double atMost)
        => _requirements.Add(new Requirement(
            $"{subject.Name} - {other.Name}, {columns[column].Name}",
            subject.Columns[column].Median - other.Columns[column].Median, atMost, string.Empty));

    /// <summary>The ratio of a figure to the limit's; null where it says nothing.</summary>
    public double? RatioOf(Subject row, int column)
    {
        if (limit is null || !columns[column].HasRatio)
            return null;
        double ratio = row.Columns[column].RatioTo(limit.Columns[column]);
        return double.IsNaN(ratio) || double.IsInfinity(ratio) ? null : ratio;
    }
}

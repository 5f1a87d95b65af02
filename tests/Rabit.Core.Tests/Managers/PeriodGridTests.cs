using System;
using Rabit.Core.Managers;
using Xunit;

namespace Rabit.Core.Tests.Managers;

/// <summary>The deadlines of a fixed period, times in milliseconds.</summary>
public sealed class PeriodGridTests
{
    private PeriodGrid _grid;

    [Fact]
    public void Next_FirstRun_BeginsTheGridThere()
        => Assert.Equal((110, 0), Next(period: 10, begin: 100, end: 103));

    [Fact]
    public void Next_RunsThatAreLate_StayOnTheGrid()
    {
        Next(10, 100, 103);
        Assert.Equal((120, 0), Next(10, begin: 111, end: 112));
        Assert.Equal((130, 0), Next(10, begin: 124, end: 126));
        Assert.Equal((140, 0), Next(10, begin: 130, end: 139));
    }

    [Fact]
    public void Next_AnotherWakeBetweenDeadlines_DoesNotMoveThem()
    {
        Next(10, 100, 103);
        Assert.Equal((110, 0), Next(10, begin: 105, end: 106));
        Assert.Equal((120, 0), Next(10, begin: 110, end: 111));
    }

    [Fact]
    public void Next_WorkPastOneDeadline_IsOneMissedDeadlineAndOneRunAtOnce()
    {
        Next(10, 100, 103);
        Assert.Equal((120, 1), Next(10, begin: 110, end: 123));
        Assert.Equal((130, 0), Next(10, begin: 123, end: 125));
    }

    [Fact]
    public void Next_WorkPastManyDeadlines_CountsThemAndRunsOnceNotForEach()
    {
        Next(10, 100, 103);
        Assert.Equal((160, 5), Next(10, begin: 110, end: 167));
        Assert.Equal((170, 0), Next(10, begin: 167, end: 168));
    }

    [Fact]
    public void Next_WokenPastManyDeadlines_CountsThoseThatHadNoRun()
    {
        Next(10, 100, 103);
        Assert.Equal((140, 2), Next(10, begin: 135, end: 136));
    }

    [Fact]
    public void Next_EndOnTheDeadlineItself_IsAMissedDeadline()
    {
        Next(10, 100, 103);
        Assert.Equal((120, 1), Next(10, begin: 110, end: 120));
    }

    [Fact]
    public void Next_AnotherPeriod_BeginsANewGrid()
    {
        Next(10, 100, 103);
        Assert.Equal((131, 0), Next(period: 20, begin: 111, end: 112));
    }

    private (int Due, int MissedDeadlines) Next(int period, int begin, int end)
    {
        TimeSpan due = _grid.Next(Milliseconds(period), Milliseconds(begin), Milliseconds(end), out long missed);
        return ((int)due.TotalMilliseconds, (int)missed);
    }

    private static TimeSpan Milliseconds(int milliseconds) => TimeSpan.FromMilliseconds(milliseconds);
}

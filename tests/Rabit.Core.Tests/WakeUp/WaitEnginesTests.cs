using System;
using Rabit.Core.WakeUp;
using Xunit;

namespace Rabit.Core.Tests.WakeUp;

public sealed class WaitEnginesTests
{
    [Theory]
    [InlineData(WaitEngine.Best, null, true, WaitEngine.Futex)]
    [InlineData(WaitEngine.Best, "", true, WaitEngine.Futex)]
    [InlineData(WaitEngine.Best, null, false, WaitEngine.Event)]
    [InlineData(WaitEngine.Best, "event", true, WaitEngine.Event)]
    [InlineData(WaitEngine.Best, "Futex", true, WaitEngine.Futex)]
    [InlineData(WaitEngine.Event, "futex", true, WaitEngine.Event)]
    [InlineData(WaitEngine.Futex, "event", true, WaitEngine.Futex)]
    public void Choose_WhatWorks_IsTakenWithoutANote(
        WaitEngine asked, string? variable, bool isFutexThere, WaitEngine expected)
    {
        Assert.Equal(expected, WaitEngines.Choose(asked, variable, isFutexThere, out string? note));
        Assert.Null(note);
    }

    [Theory]
    [InlineData(WaitEngine.Futex, null, false, WaitEngine.Event, "does not work here")]
    [InlineData(WaitEngine.Best, "futex", false, WaitEngine.Event, "does not work here")]
    [InlineData(WaitEngine.Best, "spin", true, WaitEngine.Futex, "'spin'")]
    public void Choose_WhatDoesNotWork_IsNoted(
        WaitEngine asked, string? variable, bool isFutexThere, WaitEngine expected, string inNote)
    {
        Assert.Equal(expected, WaitEngines.Choose(asked, variable, isFutexThere, out string? note));
        Assert.Contains(inNote, note, StringComparison.Ordinal);
    }

    [Fact]
    public void WaitEngine_Unknown_IsRefused()
        => Assert.Throws<ArgumentOutOfRangeException>(() => new RealTime { WaitEngine = (WaitEngine)7 });
}

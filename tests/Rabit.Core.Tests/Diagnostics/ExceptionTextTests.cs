using System;
using Rabit.Core.Diagnostics;
using Xunit;

namespace Rabit.Core.Tests.Diagnostics;

/// <summary>Contract 1.7: texts of exceptions whose own code may do anything.</summary>
public sealed class ExceptionTextTests
{
    [Fact, Trait("Clause", "1.7")]
    public void Describe_OrdinaryException_IsTypeAndMessage()
        => Assert.Equal(
            "InvalidOperationException: boom", ExceptionText.Describe(new InvalidOperationException("boom")));

    /// <summary>As the messages of .NET are that name the value of an argument.</summary>
    [Theory, Trait("Clause", "1.7")]
    [InlineData("two\r\nlines", "two lines")]
    [InlineData("two\nlines", "two lines")]
    [InlineData("two\rlines", "two lines")]
    [InlineData("\none", " one")]
    public void MessageOf_SeveralLines_IsOne(string message, string expected)
        => Assert.Equal(expected, ExceptionText.MessageOf(new InvalidOperationException(message)));

    [Theory, Trait("Clause", "1.7")]
    [InlineData(Hostility.Throws, "HostileException: (its message cannot be read: HostileException)")]
    [InlineData(Hostility.ReturnsNull, "HostileException: (its message is null)")]
    public void Describe_MessageWithoutAText_SaysSo(Hostility hostility, string expected)
        => Assert.Equal(expected, ExceptionText.Describe(new HostileException(hostility)));

    [Fact, Trait("Clause", "1.7")]
    public void MessageOf_AggregateOfAHostileOne_SaysSo()
        => Assert.NotEmpty(
            ExceptionText.MessageOf(new AggregateException(new HostileException(Hostility.Throws))));

    [Fact, Trait("Clause", "1.7")]
    public void MessageOf_HugeMessage_IsCutAndSaysSo()
    {
        string text = ExceptionText.MessageOf(new HostileException(Hostility.IsHuge));

        Assert.Equal(ExceptionText.MaxLength, text.Length);
        Assert.EndsWith("x ... (cut)", text, StringComparison.Ordinal);
    }

    [Fact]
    public void MessageOf_LongMessageOfPairs_CutsNoPair()
    {
        string pairs = string.Concat(System.Linq.Enumerable.Repeat("\U0001F681", ExceptionText.MaxLength));
        string even = ExceptionText.MessageOf(new InvalidOperationException(pairs));
        string odd = ExceptionText.MessageOf(new InvalidOperationException("x" + pairs));

        Assert.False(char.IsHighSurrogate(even[even.IndexOf(' ') - 1]));
        Assert.False(char.IsHighSurrogate(odd[odd.IndexOf(' ') - 1]));
    }

    [Fact]
    public void PlaceOf_ThrownException_IsTheFirstLineOfItsTrace()
    {
        Exception thrown = Assert.Throws<InvalidOperationException>(
            void () => throw new InvalidOperationException("boom"));

        string place = ExceptionText.PlaceOf(thrown);

        Assert.Contains(nameof(PlaceOf_ThrownException_IsTheFirstLineOfItsTrace), place, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', place);
        Assert.Empty(ExceptionText.PlaceOf(new InvalidOperationException("never thrown")));
    }

    [Theory, Trait("Clause", "1.7")]
    [InlineData(Hostility.Throws)]
    [InlineData(Hostility.ReturnsNull)]
    public void PlaceOf_TraceWithoutAText_IsEmpty(Hostility hostility)
        => Assert.Empty(ExceptionText.PlaceOf(new HostileException(hostility)));

    [Fact, Trait("Clause", "1.7")]
    public void PlaceOf_HugeTrace_IsCut()
        => Assert.Equal(
            ExceptionText.MaxLength, ExceptionText.PlaceOf(new HostileException(Hostility.IsHuge)).Length);
}

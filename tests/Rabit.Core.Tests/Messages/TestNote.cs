namespace Rabit.Core.Tests.Messages;

/// <summary>An immutable class. One that is seen before its constructor has ended is not whole.</summary>
internal sealed class TestNote(long number)
{
    private readonly long _check = ~number;

    public long Number { get; } = number;

    public bool IsWhole => _check == ~Number;
}

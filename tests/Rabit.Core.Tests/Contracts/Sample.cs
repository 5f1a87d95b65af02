namespace Rabit.Core.Tests.Contracts;

/// <summary>What the message of a <see cref="MessagePair"/> holds.</summary>
internal struct Sample
{
    public int Number;
}

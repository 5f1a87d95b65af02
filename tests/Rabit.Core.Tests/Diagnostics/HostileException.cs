using System;
using System.Collections;

namespace Rabit.Core.Tests.Diagnostics;

/// <summary>What the members of a <see cref="HostileException"/> do when they are read.</summary>
public enum Hostility
{
    /// <summary>They throw, an exception of the same kind.</summary>
    Throws,

    /// <summary>They return null.</summary>
    ReturnsNull,

    /// <summary>They return a million characters, with line breaks.</summary>
    IsHuge,

    /// <summary>They interrupt the thread that reads them, and throw.</summary>
    Interrupts,
}

/// <summary>An exception of user code whose own code does what no exception should do.</summary>
public sealed class HostileException(Hostility hostility) : Exception
{
    public override string Message => Text();

    public override string StackTrace => Text();

    public override string? HelpLink
    {
        get => Text();
        set => Text();
    }

    public override string? Source
    {
        get => Text();
        set => Text();
    }

    public override IDictionary Data => Text() is null ? null! : throw new HostileException(hostility);

    public override Exception GetBaseException() => throw new HostileException(hostility);

    public override string ToString() => Text();

    private string Text()
    {
        switch (hostility)
        {
            case Hostility.ReturnsNull:
                return null!;
            case Hostility.IsHuge:
                return new string('x', 500_000) + "\n" + new string('y', 500_000);
            case Hostility.Interrupts:
                System.Threading.Thread.CurrentThread.Interrupt();
                throw new HostileException(hostility);
            default:
                throw new HostileException(hostility);
        }
    }
}

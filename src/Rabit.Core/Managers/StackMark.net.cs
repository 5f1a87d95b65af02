using System.Runtime.CompilerServices;

namespace Rabit.Core.Managers;

/// <summary>
/// A place on the stack of a thread. What lies close below it is on the stack of the same thread, so that a comparison
/// of two addresses shows whether code that was called from there is running, without a call into the runtime.
/// </summary>
/// <remarks>
/// Requirements: it never covers a place on the stack of another thread; it may fail to cover one of its own. So it is
/// set only where the runtime says that there is stack enough below it (at least 64 KiB,
/// <see cref="RuntimeHelpers.TryEnsureSufficientExecutionStack"/>), covers half of that, and is taken back before the
/// method returns that holds it. It is one word, read and written whole.
/// <para>Measured gain: decision 0061.</para>
/// </remarks>
internal readonly unsafe struct StackMark
{
    /// <summary>Whether the stack can be marked.</summary>
    public const bool Exists = true;

    private const uint CoveredBytes = 32 * 1024;

    private readonly nuint _address;   // 0: none

    private StackMark(nuint address) => _address = address;

    public bool IsSet => _address != 0;

    /// <summary>A mark where a local variable is; none where too little stack is left.</summary>
    public static StackMark At(ref StackMark local)
        => RuntimeHelpers.TryEnsureSufficientExecutionStack() ? new StackMark(AddressOf(ref local)) : default;

    /// <summary>Whether a local variable lies close below the mark.</summary>
    public bool Covers(ref StackMark local) => unchecked(_address - AddressOf(ref local)) < CoveredBytes;

    /// <summary>Whether the caller runs close below the mark.</summary>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool IsHere()
    {
        byte here;
        return unchecked(_address - (nuint)(&here)) < CoveredBytes;
    }

    public bool IsSameAs(StackMark other) => _address == other._address;

    private static nuint AddressOf(ref StackMark local) => (nuint)Unsafe.AsPointer(ref local);
}

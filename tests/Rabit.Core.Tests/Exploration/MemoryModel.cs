namespace Rabit.Core.Tests.Exploration;

/// <summary>Which of its values a location may show to a thread.</summary>
internal enum MemoryModel
{
    /// <summary>The newest, always: no processor does this. To show which faults only a real memory has.</summary>
    SequentiallyConsistent,

    /// <summary>
    /// Each processor has a store buffer: its own writes may stay unseen by the others until an interlocked operation
    /// or a fence, volatile ones in their order (x86), plain ones in any (Arm). Reads are in order, and what one other
    /// processor has seen all see.
    /// </summary>
    StoreBuffers,

    /// <summary>Any that the rules of the .NET memory model leave open, as <see cref="ExploredMemory"/> says.</summary>
    Weak,
}

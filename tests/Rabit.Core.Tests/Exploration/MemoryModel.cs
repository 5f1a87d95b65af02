namespace Rabit.Core.Tests.Exploration;

/// <summary>Which of its values a location may show to a thread.</summary>
internal enum MemoryModel
{
    /// <summary>The newest, always: no processor does this. To show which faults only a real memory has.</summary>
    SequentiallyConsistent,

    /// <summary>Any that the rules of the .NET memory model leave open, as <see cref="ExploredMemory"/> tells.</summary>
    Weak,
}

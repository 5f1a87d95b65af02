using System;

namespace Rabit.Core.Tests.Exploration;

/// <summary>The models by their names, which a test's data must consist of.</summary>
internal static class MemoryModels
{
    public static MemoryModel Named(string name) => name switch
    {
        nameof(MemoryModel.SequentiallyConsistent) => MemoryModel.SequentiallyConsistent,
        nameof(MemoryModel.StoreBuffers) => MemoryModel.StoreBuffers,
        nameof(MemoryModel.Weak) => MemoryModel.Weak,
        _ => throw new ArgumentException($"No memory is called {name}.", nameof(name)),
    };
}

using Rabit.Core.WakeUp;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// The accesses that litmus tests and seeded faults are made of beside those of the library: what a memory may show.
/// </summary>
/// <remarks>
/// A plain access promises nothing but that an aligned 32-bit word is whole; a fence is in order with everything.
/// </remarks>
internal interface ILitmusPoints : ISyncPoints
{
    int Read(ref int location);

    void Write(ref int location, int value);

    void Fence();
}

using Rabit.Core.Locks;
using Xunit;

namespace Rabit.Core.Tests.Locks;

/// <summary>A test that needs the kernel's locks with priority inheritance.</summary>
internal sealed class LinuxFactAttribute : FactAttribute
{
    public LinuxFactAttribute()
    {
        if (!PriorityInheritanceMutex.IsThere)
            Skip = "This system has no futex with priority inheritance.";
    }
}

using System;
using Xunit;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>A test that needs the whole recordings, which are not part of the repository.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class RecordingsFactAttribute : FactAttribute
{
    public RecordingsFactAttribute(string folder)
    {
        if (RecordedHealth.Folder(folder) is null)
            Skip = $"{folder} is not there: it is looked for in ../shared/vectors beside the repository, or in the "
                + "folder that RABIT_VECTORS names.";
    }
}
